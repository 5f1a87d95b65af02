using System;
using Rabit.Mavlink.Framing;
using Rabit.Mavlink.Logs;

namespace Rabit.Mavlink;

// What makes bytes a record: a time that fits its neighbours, and a frame that its checksum proves. A frame of an
// unknown id proves nothing; it is accepted only where another record, or the end of the file, is right behind it
// (fewer bytes than a time: a record cut at the end).
public sealed partial class TlogReader
{
    private const int Lookahead = TlogFormat.MaxRecordLength + TlogFormat.TimeLength + 1;

    // How far a time may be from its neighbour's and still confirm it. Longer gaps and clock steps are accepted when
    // the record behind agrees; without a limit one flipped bit would send a replay years ahead.
    private const long NearMicroseconds = 3_600_000_000;

    private static int BytesBeforeNextStart(ReadOnlySpan<byte> rest)
    {
        if (rest.Length <= TlogFormat.TimeLength)
            return rest.Length;
        int skip = rest.Slice(TlogFormat.TimeLength).IndexOfAny(WireFormat.MagicV2, WireFormat.MagicV1);
        return skip >= 0 ? skip : rest.Length - TlogFormat.TimeLength;
    }

    private bool TryValidate(ReadOnlySpan<byte> rest, out ParsedHeader header, out long time)
    {
        header = default;
        time = TlogFormat.ReadTime(rest);
        if (time < 0)
            return false;

        ReadOnlySpan<byte> wire = rest.Slice(TlogFormat.TimeLength);
        header = ParsedHeader.Parse(wire, _messages);
        if (header.Kind is not (HeaderKind.KnownMessage or HeaderKind.UnknownMessage) || header.Length > wire.Length)
            return false;

        ReadOnlySpan<byte> following = wire.Slice(header.Length);
        return header.Kind == HeaderKind.KnownMessage
            ? TimeFits(time, following) && header.ChecksumMatches(wire)
            : following.Length <= TlogFormat.TimeLength ? IsNearLast(time) : IsConfirmedBy(following, time);
    }

    private bool TimeFits(long time, ReadOnlySpan<byte> following)
        => IsNearLast(time) || IsConfirmedBy(following, time);

    private bool IsNearLast(long time) => _lastTime is not { } last || Math.Abs(time - last) <= NearMicroseconds;

    // The record behind, if one seems to be there, is near in time, or the three times are in order however far apart.
    private bool IsConfirmedBy(ReadOnlySpan<byte> following, long time)
    {
        if (following.Length <= TlogFormat.TimeLength
            || following[TlogFormat.TimeLength] is not (WireFormat.MagicV2 or WireFormat.MagicV1))
            return false;
        long next = TlogFormat.ReadTime(following);
        if (next < 0)
            return false;
        return Math.Abs(next - time) <= NearMicroseconds || (_lastTime <= time && time <= next);
    }
}
