using System;
using System.Collections.Generic;
using System.IO;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests.Framing;

namespace Rabit.Mavlink.Tests.Logs;

/// <summary>Logs put together record by record, and read back.</summary>
internal sealed class LogBuilder
{
    /// <summary>Some day in 2026, in microseconds.</summary>
    public const long Start = 1_790_000_000_000_000;

    private readonly MemoryStream _bytes = new();
    private byte _sequence;

    public long Length => _bytes.Length;

    public LogBuilder Record(long timeMicroseconds)
        => Record(timeMicroseconds, Wire.Of(default(Heartbeat), _sequence++));

    public LogBuilder Record(long timeMicroseconds, byte[] frame)
    {
        var time = new byte[8];
        for (int i = 0; i < time.Length; i++)
            time[i] = (byte)(timeMicroseconds >> (56 - (8 * i)));
        return Raw(time).Raw(frame);
    }

    public LogBuilder Raw(params byte[] bytes)
    {
        _bytes.Write(bytes, 0, bytes.Length);
        return this;
    }

    public byte[] ToArray() => _bytes.ToArray();

    public TlogReader Read(out List<ReadRecord> records) => Read(ToArray(), out records);

    public static TlogReader Read(byte[] log, out List<ReadRecord> records)
    {
        var reader = new TlogReader(new MemoryStream(log), MavlinkDialect.All);
        records = [];
        while (reader.TryRead(out MavlinkFrame frame, out TlogRecord record))
            records.Add(new ReadRecord(record, Wire.Bytes(frame)));
        return reader;
    }
}

/// <summary>A record that was read, and the bytes of its frame.</summary>
internal readonly struct ReadRecord
{
    public ReadRecord(TlogRecord record, byte[] wire)
    {
        Record = record;
        Wire = wire;
    }

    public TlogRecord Record { get; }

    public byte[] Wire { get; }

    /// <summary>Time and frame, but not the index, which damage before it changes.</summary>
    public override string ToString() => $"{Record.TimeMicroseconds} {TestData.ToHex(Wire, Wire.Length)}";
}
