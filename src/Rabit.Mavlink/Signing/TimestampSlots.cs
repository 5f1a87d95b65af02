using System;
using System.Buffers.Binary;

namespace Rabit.Mavlink.Signing;

/// <summary>
/// The two stored places of a signing clock: a mark, a time stamp of 48 bits, a number that counts the writes, a check.
/// The newer one that is whole counts.
/// </summary>
internal sealed class TimestampSlots
{
    public const int RecordLength = 12;

    private const int SlotCount = 2;
    private const ushort Mark = 0x534D;   // "MS"
    private const int TimestampOffset = 2;
    private const int NumberOffset = 8;
    private const int CheckOffset = 10;

    private readonly IMavlinkTimestampStore _store;
    private readonly byte[] _record = new byte[RecordLength];
    private ushort _number;
    private int _next;

    /// <summary>Reads what was stored.</summary>
    public TimestampSlots(IMavlinkTimestampStore store)
    {
        _store = store;
        bool isFirst = true;
        for (int slot = 0; slot < SlotCount; slot++)
        {
            // The time stamp does not show which is newer: an orderly shutdown goes back behind what was reserved.
            if (!TryRead(slot, out long timestamp, out ushort number)
                || (!isFirst && unchecked((short)(number - _number)) < 0))
                continue;
            Newest = timestamp;
            _number = number;
            _next = (slot + 1) % SlotCount;
            isFirst = false;
        }
    }

    /// <summary>The time stamp stored last; 0 where there is none.</summary>
    public long Newest { get; private set; }

    /// <summary>Stores a time stamp in the place of the older one.</summary>
    public bool TryWrite(long timestamp)
    {
        ushort number = unchecked((ushort)(_number + 1));
        BinaryPrimitives.WriteUInt16LittleEndian(_record, Mark);
        BinaryPrimitives.WriteInt64LittleEndian(_record.AsSpan(TimestampOffset), timestamp);
        BinaryPrimitives.WriteUInt16LittleEndian(_record.AsSpan(NumberOffset), number);
        BinaryPrimitives.WriteUInt16LittleEndian(_record.AsSpan(CheckOffset), Check());
        if (!_store.Write(_next, _record))
            return false;
        _next = (_next + 1) % SlotCount;
        _number = number;
        Newest = timestamp;
        return true;
    }

    private bool TryRead(int slot, out long timestamp, out ushort number)
    {
        bool isWhole = _store.Read(slot, _record) == RecordLength
            && BinaryPrimitives.ReadUInt16LittleEndian(_record) == Mark
            && BinaryPrimitives.ReadUInt16LittleEndian(_record.AsSpan(CheckOffset)) == Check();
        timestamp = BinaryPrimitives.ReadInt64LittleEndian(_record.AsSpan(TimestampOffset))
            & SignatureFormat.MaxTimestamp;
        number = BinaryPrimitives.ReadUInt16LittleEndian(_record.AsSpan(NumberOffset));
        return isWhole;
    }

    private ushort Check() => MavlinkCrc.Add(MavlinkCrc.Initial, _record.AsSpan(0, CheckOffset));
}
