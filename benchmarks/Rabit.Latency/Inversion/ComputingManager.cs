using System;
using Rabit.Core;
using Rabit.Latency.Contention;
using Rabit.Latency.Native;

namespace Rabit.Latency.Inversion;

/// <summary>
/// The manager in the middle: computes for a long time, as often as leaves room for the lowest, and takes nothing from
/// its queue.
/// </summary>
internal sealed class ComputingManager : RabitManager
{
    public const string QueueName = "poses";
    public const int QueueCapacity = 16;
    private static readonly TimeSpan Rest = TimeSpan.FromMilliseconds(15);

    private readonly long _nanoseconds;

    public ComputingManager(int priority, int cpu, TimeSpan work, QueueFullMode? receives)
        : base("middle")
    {
        RequestRealTime(new RealTimeRequest { Priority = priority, Cpus = [cpu] });
        if (receives is { } whenFull)
            Receive<TestPose>(QueueName, QueueCapacity, whenFull, wakeOnPush: false);
        _nanoseconds = work.Ticks * 100;
        Period = work + Rest;
    }

    protected override void ExecuteUnitOfWork()
    {
        // Its own processor time: what the highest takes in between is not computed.
        long end = MonotonicClock.ThreadTime + _nanoseconds;
        while (MonotonicClock.ThreadTime < end)
        {
            // It computes.
        }
    }
}
