using BenchmarkDotNet.Attributes;

namespace Rabit.Benchmarks.Core;

/// <summary>Changing one member and posting the whole. Rabit's post reads the clock for the stamp; so does <see cref="LockWithTime"/>.</summary>
public class PostBenchmarks : MessageBenchmarks
{
    private VehiclePose _posted;

    [Benchmark(Baseline = true)]
    public void Lock()
    {
        _posted.TimeSeconds++;
        Locked.Post(_posted);
    }

    [Benchmark]
    public void LockWithTime()
    {
        _posted.TimeSeconds++;
        Locked.PostWithTime(_posted);
    }

    [Benchmark]
    public bool Channel()
    {
        _posted.TimeSeconds++;
        return LatestValue.Writer.TryWrite(_posted);
    }

    [Benchmark]
    public void Rabit()
    {
        Publisher.Value.TimeSeconds++;
        Publisher.Post();
    }

    [Benchmark]
    public void RabitWithGivenTime()
    {
        Publisher.Value.TimeSeconds++;
        Publisher.Post(System.TimeSpan.Zero);
    }
}
