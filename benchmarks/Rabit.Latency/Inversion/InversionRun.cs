using System;
using System.Linq;
using Rabit.Core;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;

namespace Rabit.Latency.Inversion;

/// <summary>Three managers of three priorities on one CPU, which are there only while they are measured.</summary>
internal sealed class InversionRun(EndpointCall highest, EndpointCall lowest, TimeSpan work)
{
    private const int Lowest = 5;
    private const int Middle = 10;
    private const int Highest = 20;
    private const int WarmUpCalls = 200;
    private const double NanosecondsPerMicrosecond = 1000;

    // Neither of the others may be the receiver: both push.
    private QueueFullMode? WhatTheMiddleReceives => highest switch
    {
        EndpointCall.PushDroppingOldest => QueueFullMode.DropOldest,
        EndpointCall.PushDroppingNewest => QueueFullMode.DropNewest,
        _ => null,
    };

    /// <summary>Whether the machine grants such priorities; without them nothing is shown.</summary>
    public static bool HasPriorities()
    {
        RabitReactor reactor = RabitRun.Create(WaitEngine.Best);
        using var manager = new UrgentManager(Highest, Cpus.One, EndpointCall.PostAlone, reactor.Workspace);
        reactor.Add(manager);
        reactor.Start();
        RabitRun.End(reactor);
        return manager.RealTimeReport.Grants.All(g => g.IsGranted);
    }

    /// <returns>The median, 99.9 % and the longest of so many calls, in microseconds.</returns>
    public double[] Measure(int calls)
    {
        int cpu = Cpus.One;
        RabitReactor reactor = RabitRun.Create(WaitEngine.Best);
        using var calling = new UrgentManager(Highest, cpu, highest, reactor.Workspace);
        reactor.Add(new BackgroundManager(Lowest, cpu, lowest, reactor.Workspace));
        reactor.Add(new ComputingManager(Middle, cpu, work, WhatTheMiddleReceives));
        reactor.Add(calling);
        reactor.Start();
        calling.Measure(WarmUpCalls);
        LatencyHistogram durations = calling.Measure(calls);
        RabitRun.End(reactor);
        return
        [
            durations.Percentile(0.5) / NanosecondsPerMicrosecond,
            durations.Percentile(0.999) / NanosecondsPerMicrosecond,
            durations.Max / NanosecondsPerMicrosecond,
        ];
    }
}
