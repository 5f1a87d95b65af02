using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Latency.Reporting;

namespace Rabit.Latency.Periods;

/// <summary>
/// What the real-time kit gains on this machine: the same manager with and without it, on a CPU that has other work to
/// do.
/// </summary>
internal static class RealTimeMode
{
    private static readonly TimeSpan Period = TimeSpan.FromMilliseconds(2);

    public static Table Run(RunOptions options)
    {
        int samples = options.Pick(50, 500);
        using var competitor = new CompetingLoad(Cpus.One);
        List<Subject> subjects =
        [
            Row("as it is", request: null, samples),
            Row("timer slack 1 µs", new RealTimeRequest { TimerSlack = TimeSpan.FromTicks(10) }, samples),
            Row("priority FIFO 50", new RealTimeRequest { Priority = 50 }, samples),
        ];
        Rounds.Run(subjects, options.Pick(1, options.Rounds));
        foreach (Subject subject in subjects)
            subject.Dispose();
        return new Table(
            "realtime",
            "a manager at 500 Hz, futex engine, beside a thread that computes without end on the same CPU: how late",
            [new Column("p50 µs"), new Column("p99 µs"), new Column("kept %", "0.0", hasRatio: false)],
            subjects,
            subjects[0], "base");
    }

    private static Subject Row(string name, RealTimeRequest? request, int samples)
    {
        var target = new RabitPeriod(WaitEngine.Best, Cpus.One, request);
        RealTimeGrant? refused = target.RealTime.Grants.FirstOrDefault(g => !g.IsGranted);
        string title = refused is null ? name : $"{name} (not granted)";
        return new Subject(title, () => target.Lateness(Period, samples)).Owning(target);
    }
}
