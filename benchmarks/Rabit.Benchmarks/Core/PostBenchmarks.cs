using System;
using BenchmarkDotNet.Attributes;

namespace Rabit.Benchmarks.Core;

/// <summary>
/// Changing one member and posting the whole. Rabit's post reads the clock for the stamp, unless it is given a time; so
/// do <see cref="HandWrittenWithTime"/> and <see cref="LockWithTime"/>.
/// </summary>
public class PostBenchmarks : MessageBenchmarks
{
    private readonly SeqlockMessage<VehiclePose> _handWritten = new();
    private VehiclePose _posted;

    [Benchmark(OperationsPerInvoke = Operations)]
    public void HandWritten() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            _posted.TimeSeconds++;
            _handWritten.Post(_posted, 0);
        }
    });

    [Benchmark(OperationsPerInvoke = Operations)]
    public void HandWrittenWithTime() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            _posted.TimeSeconds++;
            _handWritten.PostWithTime(_posted);
        }
    });

    [Benchmark(Baseline = true, OperationsPerInvoke = Operations)]
    public void Lock() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            _posted.TimeSeconds++;
            Locked.Post(_posted);
        }
    });

    [Benchmark(OperationsPerInvoke = Operations)]
    public void LockWithTime() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            _posted.TimeSeconds++;
            Locked.PostWithTime(_posted);
        }
    });

    [Benchmark(OperationsPerInvoke = Operations)]
    public void Channel() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            _posted.TimeSeconds++;
            LatestValue.Writer.TryWrite(_posted);
        }
    });

    [Benchmark(OperationsPerInvoke = Operations)]
    public void Rabit() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            Manager.Pose.Value.TimeSeconds++;
            Manager.Pose.Post();
        }
    });

    [Benchmark(OperationsPerInvoke = Operations)]
    public void RabitWakesOneThatIsAwake() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            Manager.WakingPose.Value.TimeSeconds++;
            Manager.WakingPose.Post();
        }
    });

    [Benchmark(OperationsPerInvoke = Operations)]
    public void RabitGivenTime() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            Manager.Pose.Value.TimeSeconds++;
            Manager.Pose.PostStamped(TimeSpan.Zero);
        }
    });

    [Benchmark(OperationsPerInvoke = Operations)]
    public void RabitOutsideManagersGivenTime() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            OutsidePose.Value.TimeSeconds++;
            OutsidePose.PostStamped(TimeSpan.Zero);
        }
    });
}
