using System;
using BenchmarkDotNet.Attributes;

namespace Rabit.Benchmarks.Core;

/// <summary>A post and the fetch that sees it, on one thread, without reading a clock.</summary>
public class FetchChangedBenchmarks : MessageBenchmarks
{
    private VehiclePose _posted;
    private VehiclePose _fetched;
    private long _seen;
    private int _news;

    [Benchmark(Baseline = true, OperationsPerInvoke = Operations)]
    public void Lock() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            _posted.TimeSeconds++;
            Locked.Post(_posted);
            if (Locked.Fetch(ref _fetched, ref _seen))
                _news++;
        }
    });

    [Benchmark(OperationsPerInvoke = Operations)]
    public void Channel() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            _posted.TimeSeconds++;
            if (LatestValue.Writer.TryWrite(_posted) && LatestValue.Reader.TryRead(out _fetched))
                _news++;
        }
    });

    [Benchmark(OperationsPerInvoke = Operations)]
    public void Rabit() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            Manager.Pose.Value.TimeSeconds++;
            Manager.Pose.PostStamped(TimeSpan.Zero);
            if (Pose.Fetch())
                _news++;
        }
    });

    [Benchmark(OperationsPerInvoke = Operations)]
    public void RabitImmutableClass() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            Manager.Plan.Value = MessageManager.Plans[i & 1];
            Manager.Plan.PostStamped(TimeSpan.Zero);
            if (Plan.Fetch())
                _news++;
        }
    });

    [Benchmark(OperationsPerInvoke = Operations)]
    public void RabitSelfCopyingClass() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            Manager.Scan.Value.Metres[0]++;
            Manager.Scan.PostStamped(TimeSpan.Zero);
            if (Scan.Fetch())
                _news++;
        }
    });
}
