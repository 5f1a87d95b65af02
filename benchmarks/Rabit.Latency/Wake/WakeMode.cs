using System.Collections.Generic;
using Rabit.Core;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Latency.Reporting;
using Rabit.Latency.Signals;

namespace Rabit.Latency.Wake;

/// <summary>How long after a post the first line of the sleeper's work runs.</summary>
internal static class WakeMode
{
    private const int P50 = 0;
    private const int P99 = 1;
    private const double MaxP50Microseconds = 8;
    private const double MaxP99Microseconds = 28;

    public static Table Run(RunOptions options)
    {
        int posts = options.Pick(100, 500);
        var subjects = new List<Subject>();
        foreach ((string name, System.Func<Signal> create) in Baselines.All)
            subjects.Add(Row(name, new BaselineWake(create(), Cpus.One), posts));
        Subject futex = Row(RabitRun.NameOf(WaitEngine.Futex), new RabitWake(WaitEngine.Futex, Cpus.One), posts);
        Subject byEvent = Row(RabitRun.NameOf(WaitEngine.Event), new RabitWake(WaitEngine.Event, Cpus.One), posts);
        subjects.Add(futex);
        subjects.Add(byEvent);

        Rounds.Run(subjects, options.Pick(1, options.Rounds));
        foreach (Subject subject in subjects)
            subject.Dispose();

        var table = new Table(
            "wake",
            $"post to the first line of the sleeper's work, both on one CPU, 1 kHz, {posts} a round",
            [new Column("p50 µs"), new Column("p99 µs"), new Column("max µs", "0", hasRatio: false)],
            subjects,
            subjects[0]);
        table.RequireRatio(futex, subjects[0], P50, 1.3);
        table.RequireRatio(futex, subjects[0], P99, 1.3);
        table.RequireMax(futex, P50, MaxP50Microseconds);
        table.RequireMax(futex, P99, MaxP99Microseconds);
        table.RequireRatio(byEvent, subjects[1], P50, 1.15);
        table.RequireRatio(byEvent, subjects[1], P99, 1.15);
        return table;
    }

    private static Subject Row(string name, WakeTarget target, int posts)
        => new Subject(name, () => target.Run(Cpus.One, posts)).Owning(target);
}
