using System;
using System.Buffers.Binary;
using Rabit.Mavlink.Framing;

namespace Rabit.Mavlink.Logs;

/// <summary>
/// A telemetry log as all ground stations write it: records one after another, each 8 bytes of time (microseconds since
/// 1970 UTC, big endian) and one frame as it was on the wire. No header, no index.
/// </summary>
internal static class TlogFormat
{
    public const int TimeLength = 8;
    public const int MaxRecordLength = TimeLength + WireFormat.MaxFrameLength;

    /// <summary>2100-01-01 UTC: a later time is damage.</summary>
    public const long MaxTime = 4_102_444_800_000_000;

    private const int TicksPerMicrosecond = 10;

    private static readonly DateTime Epoch = new(1970, 1, 1, 0, 0, 0, DateTimeKind.Utc);

    /// <summary>The time at the start of a record; negative where no recorder can have written it.</summary>
    public static long ReadTime(ReadOnlySpan<byte> record)
    {
        ulong time = BinaryPrimitives.ReadUInt64BigEndian(record);
        return time <= MaxTime ? (long)time : -1;
    }

    public static void WriteTime(Span<byte> record, long timeMicroseconds)
        => BinaryPrimitives.WriteInt64BigEndian(record, timeMicroseconds);

    public static DateTime ToUtc(long timeMicroseconds) => Epoch.AddTicks(timeMicroseconds * TicksPerMicrosecond);
}
