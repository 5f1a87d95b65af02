using BenchmarkDotNet.Attributes;
using Rabit.Mavlink.Messages;

namespace Rabit.Benchmarks.Mavlink;

/// <summary>From the bytes of one MAVLink 2 frame to the message: framing, checksum, fields.</summary>
public class DecodeBenchmarks
{
    private readonly WireMessage<Heartbeat> _heartbeat = new(Samples.Heartbeat);
    private readonly WireMessage<Attitude> _attitude = new(Samples.Attitude);
    private readonly WireMessage<GlobalPositionInt> _position = new(Samples.GlobalPositionInt);

    [Benchmark]
    public bool Heartbeat() => _heartbeat.Decode(out _);

    [Benchmark]
    public bool Attitude() => _attitude.Decode(out _);

    [Benchmark]
    public bool GlobalPositionInt() => _position.Decode(out _);
}
