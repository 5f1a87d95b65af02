using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Threading;
using Rabit.Core;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Latency.Reporting;

namespace Rabit.Latency.Periods;

/// <summary>How late managers with a fixed period are, and whether they drift.</summary>
internal static class PeriodMode
{
    private const int P50 = 0;
    private const int P99 = 1;

    private static readonly TimeSpan TenMilliseconds = TimeSpan.FromMilliseconds(10);
    private static readonly TimeSpan HalfAMillisecond = TimeSpan.FromTicks(5000);

    public static IReadOnlyList<Table> Run(RunOptions options)
    {
        Table common = Lateness(options, TenMilliseconds, "100 Hz", options.Pick(20, 200), options.Rounds);
        Require(common, withEvents: true);

        // The event engine counts in milliseconds: it cannot keep every deadline of this period, and says so by its
        // missed deadlines.
        Table fast = Lateness(options, HalfAMillisecond, "2 kHz", options.Pick(100, 1000), options.Rounds);
        Require(fast, withEvents: false);
        return [common, fast, Drift(options)];
    }

    private static void Require(Table table, bool withEvents)
    {
        Subject limit = table.Limit!;
        Subject futex = table.Rows.Single(r => r.Name == RabitRun.NameOf(WaitEngine.Futex));
        table.RequireRatio(futex, limit, P50, 1.2);
        table.RequireRatio(futex, limit, P99, 1.2);
        if (!withEvents)
            table.RequireMin(futex, 2, 99);
    }

    private static Table Lateness(RunOptions options, TimeSpan period, string name, int samples, int rounds)
    {
        List<(string Name, PeriodTarget Target)> targets = Absolute();
        List<Subject> subjects =
            [.. targets.Select(t => new Subject(t.Name, () => t.Target.Lateness(period, samples)).Owning(t.Target))];
        Rounds.Run(subjects, options.Pick(1, rounds));
        foreach (Subject subject in subjects)
            subject.Dispose();
        return new Table(
            "period",
            string.Format(
                CultureInfo.InvariantCulture, "{0}, absolute deadlines, on one CPU: how late, {1} a round", name,
                samples),
            [new Column("p50 µs"), new Column("p99 µs"), new Column("kept %", "0.0", hasRatio: false)],
            subjects,
            subjects[0]);
    }

    // All at once: it is the mean over a long time that counts here.
    private static Table Drift(RunOptions options)
    {
        double seconds = options.Pick(1.0, 60.0);
        List<(string Name, PeriodTarget Target)> targets = Absolute();
        targets.Add(("WaitOne(10) again and again", new RelativePeriod(Cpus.One)));
        targets.Add(("Timer of 10 ms", new TimerPeriod()));
        var records = new DeadlineRecord[targets.Count];
        Thread[] threads = [.. targets.Select((target, i) => new Thread(()
            => records[i] = target.Target.Collect(TenMilliseconds, (int)(seconds * 100))) { IsBackground = true })];
        foreach (Thread thread in threads)
            thread.Start();
        foreach (Thread thread in threads)
            thread.Join();

        List<Subject> subjects =
            [.. targets.Select((target, i) => new Subject(target.Name, () => [records[i].Drift(), records[i].Missed]))];
        Rounds.Run(subjects, rounds: 1, warmUps: 0);
        foreach ((string _, PeriodTarget target) in targets)
            target.Dispose();
        var table = new Table(
            "period",
            string.Format(
                CultureInfo.InvariantCulture, "100 Hz for {0} s, all at once: by how much the mean period is wrong",
                seconds),
            [new Column("drift ppm", "0.00"), new Column("missed", "0")],
            subjects);
        foreach (Subject row in subjects.Where(s => s.Name.StartsWith("Rabit", StringComparison.Ordinal)))
        {
            table.RequireMax(row, 0, 10);
            table.RequireMin(row, 0, -10);
        }

        return table;
    }

    private static List<(string Name, PeriodTarget Target)> Absolute() =>
    [
        ("futex loop", BaselinePeriod.ByFutex(Cpus.One)),
        ("clock_nanosleep", new BaselinePeriod(MonotonicClock.SleepUntil, Cpus.One)),
        (RabitRun.NameOf(WaitEngine.Futex), new RabitPeriod(WaitEngine.Futex, Cpus.One)),
        (RabitRun.NameOf(WaitEngine.Event), new RabitPeriod(WaitEngine.Event, Cpus.One)),
    ];
}
