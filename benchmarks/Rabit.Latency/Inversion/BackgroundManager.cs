using System;
using Rabit.Core;
using Rabit.Latency.Native;

namespace Rabit.Latency.Inversion;

/// <summary>
/// The manager of the lowest priority: uses its endpoint flat out most of the time, and rests so often that the kernel
/// need not throttle the real-time threads.
/// </summary>
internal sealed class BackgroundManager : CallingManager
{
    private const long BusyNanoseconds = 3_000_000;
    private const int CallsBetweenLooks = 64;

    public BackgroundManager(int priority, int cpu, EndpointCall call, RabitWorkspace workspace)
        : base("lowest", priority, cpu, call, workspace)
        // No part of the middle one's period, which would begin at the same time always.
        => Period = TimeSpan.FromTicks(51_700);

    protected override void ExecuteUnitOfWork()
    {
        long end = MonotonicClock.ThreadTime + BusyNanoseconds;
        while (MonotonicClock.ThreadTime < end)
        {
            for (int i = 0; i < CallsBetweenLooks; i++)
                Call();
        }
    }
}
