using System;
using System.Collections.Generic;

namespace Rabit.Mavlink.Tests.Signing;

/// <summary>A store in memory, which can fail and tear.</summary>
internal sealed class TwoSlots : IMavlinkTimestampStore
{
    public byte[][] Slots { get; } = [[], []];

    public bool IsBroken { get; set; }

    /// <summary>Slot numbers, in the order of the writes.</summary>
    public List<int> Writes { get; } = [];

    public int Read(int slot, Span<byte> record)
    {
        Slots[slot].CopyTo(record);
        return Slots[slot].Length;
    }

    public bool Write(int slot, ReadOnlySpan<byte> record)
    {
        if (IsBroken)
            return false;
        Slots[slot] = record.ToArray();
        Writes.Add(slot);
        return true;
    }
}
