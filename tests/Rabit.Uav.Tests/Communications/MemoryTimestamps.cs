using System;
using Rabit.Mavlink;

namespace Rabit.Uav.Tests.Communications;

/// <summary>A store of a signing clock in memory, which may be broken.</summary>
internal sealed class MemoryTimestamps : IMavlinkTimestampStore
{
    private readonly byte[][] _slots = [[], []];

    public bool IsBroken { get; set; }

    public int Writes { get; private set; }

    public int Read(int slot, Span<byte> record)
    {
        _slots[slot].CopyTo(record);
        return _slots[slot].Length;
    }

    public bool Write(int slot, ReadOnlySpan<byte> record)
    {
        if (IsBroken)
            return false;
        _slots[slot] = record.ToArray();
        Writes++;
        return true;
    }
}
