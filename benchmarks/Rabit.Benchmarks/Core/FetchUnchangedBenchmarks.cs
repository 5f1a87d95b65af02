using BenchmarkDotNet.Attributes;

namespace Rabit.Benchmarks.Core;

/// <summary>Asking for news when there is none: what most fetches of a control loop do.</summary>
public class FetchUnchangedBenchmarks : MessageBenchmarks
{
    private VehiclePose _copy;
    private long _seen;

    [Benchmark(Baseline = true)]
    public bool Lock() => Locked.Fetch(ref _copy, ref _seen);

    [Benchmark]
    public bool Channel() => LatestValue.Reader.TryRead(out _copy);

    [Benchmark]
    public bool Rabit() => Subscriber.Fetch();
}
