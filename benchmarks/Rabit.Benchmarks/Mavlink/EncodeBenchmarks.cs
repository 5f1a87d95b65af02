using BenchmarkDotNet.Attributes;
using Rabit.Mavlink.Messages;

namespace Rabit.Benchmarks.Mavlink;

/// <summary>From the message to the bytes of one MAVLink 2 frame: fields, checksum, header.</summary>
public class EncodeBenchmarks
{
    private readonly WireMessage<Heartbeat> _heartbeat = new(Samples.Heartbeat);
    private readonly WireMessage<Attitude> _attitude = new(Samples.Attitude);
    private readonly WireMessage<GlobalPositionInt> _position = new(Samples.GlobalPositionInt);

    [Benchmark]
    public int Heartbeat() => _heartbeat.Encode();

    [Benchmark]
    public int Attitude() => _attitude.Encode();

    [Benchmark]
    public int GlobalPositionInt() => _position.Encode();
}
