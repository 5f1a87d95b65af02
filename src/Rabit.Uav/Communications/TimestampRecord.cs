using System;
using System.Buffers.Binary;

namespace Rabit.Uav.Communications;

/// <summary>One of the two places of a stored signing clock, on its way to the store. A plain value.</summary>
internal struct TimestampRecord
{
    public const int Length = sizeof(ulong) + sizeof(uint);

    private ulong _first;
    private uint _rest;

    /// <summary>0 or 1.</summary>
    public int Slot { get; private set; }

    public static TimestampRecord Of(int slot, ReadOnlySpan<byte> bytes) => new()
    {
        Slot = slot,
        _first = BinaryPrimitives.ReadUInt64LittleEndian(bytes),
        _rest = BinaryPrimitives.ReadUInt32LittleEndian(bytes.Slice(sizeof(ulong))),
    };

    public readonly void CopyTo(Span<byte> bytes)
    {
        BinaryPrimitives.WriteUInt64LittleEndian(bytes, _first);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes.Slice(sizeof(ulong)), _rest);
    }
}
