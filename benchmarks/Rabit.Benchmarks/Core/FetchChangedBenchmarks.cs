using BenchmarkDotNet.Attributes;

namespace Rabit.Benchmarks.Core;

/// <summary>A post and the fetch that sees it, on one thread. Less <see cref="PostBenchmarks"/> it is the fetch alone.</summary>
public class FetchChangedBenchmarks : MessageBenchmarks
{
    private VehiclePose _posted;
    private VehiclePose _fetched;
    private long _seen;

    [Benchmark(Baseline = true)]
    public bool Lock()
    {
        _posted.TimeSeconds++;
        Locked.Post(_posted);
        return Locked.Fetch(ref _fetched, ref _seen);
    }

    [Benchmark]
    public bool LockWithTime()
    {
        _posted.TimeSeconds++;
        Locked.PostWithTime(_posted);
        return Locked.Fetch(ref _fetched, ref _seen);
    }

    [Benchmark]
    public bool Channel()
    {
        _posted.TimeSeconds++;
        return LatestValue.Writer.TryWrite(_posted) && LatestValue.Reader.TryRead(out _fetched);
    }

    [Benchmark]
    public bool Rabit()
    {
        Publisher.Value.TimeSeconds++;
        Publisher.Post();
        return Subscriber.Fetch();
    }
}
