using System;
using System.IO;
using BenchmarkDotNet.Attributes;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Benchmarks.Mavlink;

/// <summary>
/// Reading a recorded flight of ArduPilot, from memory: the time and the allocation per record, the readers themselves
/// included.
/// </summary>
public class RecordedFlightBenchmarks
{
    private const int Records = 20_921;
    private const int ChunkLength = 1024;

    private readonly byte[] _log = File.ReadAllBytes(
        Path.Combine(AppContext.BaseDirectory, "data", "ardupilot-flight.tlog"));
    private readonly MavlinkFrameReader _reader = new(MavlinkDialect.All);
    private byte[] _stream = [];

    /// <summary>The frames of the log one after another, as a link would carry them.</summary>
    [GlobalSetup]
    public void MakeStream()
    {
        using var stream = new MemoryStream();
        var wire = new byte[MavlinkFrame.MaxWireLength];
        var log = new TlogReader(new MemoryStream(_log), MavlinkDialect.All);
        while (log.TryRead(out MavlinkFrame frame, out _))
            stream.Write(wire, 0, frame.WriteTo(wire));
        _stream = stream.ToArray();

        int records = ReadLog();
        int frames = ReadStream();
        if (records != Records || frames != Records)
            throw new InvalidOperationException(
                $"The flight has {Records} records; {records} were read from the log and {frames} from the stream.");
    }

    [Benchmark(OperationsPerInvoke = Records)]
    public int ReadLog()
    {
        int records = 0;
        var log = new TlogReader(new MemoryStream(_log), MavlinkDialect.All);
        while (log.TryRead(out _, out _))
            records++;
        return records;
    }

    [Benchmark(OperationsPerInvoke = Records)]
    public float ReadLogAndDecodeAttitude()
    {
        float roll = 0;
        var log = new TlogReader(new MemoryStream(_log), MavlinkDialect.All);
        while (log.TryRead(out MavlinkFrame frame, out _))
        {
            if (frame.TryDecode(out Attitude attitude))
                roll += attitude.Roll;
        }

        return roll;
    }

    [Benchmark(OperationsPerInvoke = Records)]
    public int ReadStream()
    {
        int frames = 0;
        for (int start = 0; start < _stream.Length; start += ChunkLength)
        {
            ReadOnlySpan<byte> chunk = _stream.AsSpan(start, Math.Min(ChunkLength, _stream.Length - start));
            while (_reader.TryRead(ref chunk, out _, out _))
                frames++;
        }

        while (_reader.TryFlush(out _, out _))
            frames++;
        return frames;
    }
}
