using System;
using System.Collections.Generic;
using Rabit.Mavlink.Framing;
using Rabit.Mavlink.Logs;

namespace Rabit.Mavlink;

// Records that stand whole between their neighbours and whose checksum is wrong all the same. QGroundControl cuts the
// trailing zeros of a payload and keeps the checksum of the frame as it was sent; put back, they make it right. What
// does not become right so is refused, and its id noted: a stream of bytes cannot know that, a log has borders.
public sealed partial class TlogReader
{
    private const int MaxRefusedIds = 256;

    private readonly Dictionary<int, long> _refused = [];
    private readonly byte[] _mended = new byte[WireFormat.MaxFrameLength];
    private long _refusedUntil;

    private bool TryMend(ReadOnlySpan<byte> rest, out MavlinkFrame frame, out TlogRecord record)
    {
        frame = default;
        record = default;
        long time = TlogFormat.ReadTime(rest);
        ReadOnlySpan<byte> wire = rest.Slice(TlogFormat.TimeLength);
        if (time < 0 || !TryMeasure(wire, out int id, out int length) || !HasBorders(wire, length, time))
            return false;
        int index = _messages.IndexOf(id);
        if (index == 0)
            return false;

        ref readonly MavlinkMessageInfo message = ref _messages.At(index);
        if (wire[0] != WireFormat.MagicV2 || !TryPad(wire.Slice(0, length), message))
        {
            Refuse(id, Position + TlogFormat.TimeLength + length);
            return false;
        }

        record = new TlogRecord(
            Records + IncompatibleRecords, Position, time, isChecked: true, message, isMended: true);
        MavlinkFrame.FromWire(_mended, out frame);
        _start += TlogFormat.TimeLength + length;
        _lastTime = time;
        Records++;
        MendedRecords++;
        return true;
    }

    // A record of its own: its time is near its neighbours', and another one, or the end of the file, is right behind.
    private bool HasBorders(ReadOnlySpan<byte> wire, int length, long time)
    {
        if (length > wire.Length || !IsNearLast(time))
            return false;
        ReadOnlySpan<byte> following = wire.Slice(length);
        if (following.Length <= TlogFormat.TimeLength)
            return following.IsEmpty && _lastTime is not null;
        return following[TlogFormat.TimeLength] is WireFormat.MagicV2 or WireFormat.MagicV1
            && TlogFormat.ReadTime(following) is >= 0 and long next && Math.Abs(next - time) <= NearMicroseconds;
    }

    // What the header says, whether or not such a message can be so long.
    private static bool TryMeasure(ReadOnlySpan<byte> wire, out int id, out int length)
    {
        (id, length) = (0, 0);
        bool isV2 = wire[0] == WireFormat.MagicV2;
        int header = isV2 ? WireFormat.HeaderLengthV2 : WireFormat.HeaderLengthV1;
        if (wire.Length < header)
            return false;
        id = isV2 ? wire[7] | (wire[8] << 8) | (wire[9] << 16) : wire[5];
        length = header + wire[1] + WireFormat.ChecksumLength
            + (isV2 ? WireFormat.SignatureLength * (wire[2] & WireFormat.SignedFlag) : 0);
        return true;
    }

    // As the sender had it: some cut none of the zeros, some a part of them. Of records that are damaged one in 65536
    // for each zero that may be missing is mended wrongly; a cut payload does not end with a zero.
    private bool TryPad(ReadOnlySpan<byte> wire, in MavlinkMessageInfo message)
    {
        int stored = wire[1];
        int end = WireFormat.HeaderLengthV2 + stored;
        bool hasUnknownFlags = (wire[2] & ~WireFormat.SignedFlag) != 0;
        if (hasUnknownFlags || stored >= message.MaxLength || (stored > 1 && wire[end - 1] == 0))
            return false;
        ReadOnlySpan<byte> tail = wire.Slice(end);
        Array.Clear(_mended, 0, _mended.Length);
        wire.Slice(0, end).CopyTo(_mended);
        int checksum = tail[0] | (tail[1] << 8);
        for (int length = stored + 1; length <= message.MaxLength; length++)
        {
            _mended[1] = (byte)length;
            int padded = WireFormat.HeaderLengthV2 + length;
            if (MavlinkCrc.OfFrame(_mended.AsSpan(1, padded - 1), message.CrcExtra) != checksum)
                continue;
            tail.CopyTo(_mended.AsSpan(padded));
            return true;
        }

        return false;
    }

    // The search goes on inside of it, so that nothing is lost where it was no record after all.
    private void Refuse(int id, long end)
    {
        if (Position < _refusedUntil)
            return;
        _refusedUntil = end;
        RefusedRecords++;
        if (_refused.TryGetValue(id, out long count))
            _refused[id] = count + 1;
        else if (_refused.Count < MaxRefusedIds)
            _refused.Add(id, 1);
    }
}
