using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Threading;
using Rabit.Core;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Latency.Reporting;

namespace Rabit.Latency.Idle;

/// <summary>What sixteen managers that have nothing to do cost.</summary>
internal static class IdleMode
{
    // Whole periods: each thread wakes as often in every round.
    public static IReadOnlyList<Table> Run(RunOptions options) =>
    [
        Run(options, TimeSpan.FromSeconds(1), options.Pick(0.5, 1.0), 0.3),
        Run(options, TimeSpan.FromMilliseconds(10), options.Pick(0.2, 1.0), 4.4),
    ];

    private static Table Run(RunOptions options, TimeSpan period, double seconds, double limit)
    {
        long nanoseconds = period.Ticks * 100;
        Subject nothing = Row("nothing at all", seconds, () => null);
        Subject byFutex = Row("threads on futexes", seconds, () => new BaselineSleepers(() => OnFutex(nanoseconds)));
        Subject futex = Row(
            RabitRun.NameOf(WaitEngine.Futex), seconds, () => new RabitSleepers(WaitEngine.Futex, period));
        Subject byEvent = Row(
            RabitRun.NameOf(WaitEngine.Event), seconds, () => new RabitSleepers(WaitEngine.Event, period));
        List<Subject> subjects =
        [
            byFutex,
            nothing,
            Row("AutoResetEvent.WaitOne(period)", seconds, () => BaselineSleepers.OnEvents(period)),
            Row("SemaphoreSlim.Wait(period)", seconds, () => new BaselineSleepers(() => OnSemaphore(period))),
            futex,
            byEvent,
        ];
        Rounds.Run(subjects, options.Pick(1, options.Rounds), warmUps: options.Pick(0, 1));
        var table = new Table(
            "idle",
            string.Format(
                CultureInfo.InvariantCulture, "{0} threads that wake every {1} ms and do nothing", Sleepers.Number,
                period.TotalMilliseconds),
            [new Column("% of a core", "0.00")],
            subjects,
            byFutex);
        table.RequireMax(futex, 0, limit);
        table.RequireMax(byEvent, 0, limit);
        return table;
    }

    private static Subject Row(string name, double seconds, Func<Sleepers?> create)
    {
        return new Subject(name, () => Measure(seconds), warmUp: () => Measure(seconds / 10));

        double[] Measure(double duration)
        {
            using Sleepers? sleepers = create();
            MonotonicClock.SleepMilliseconds(100);   // what the start costs is not what is asked
            return [CpuLoad.During(duration)];
        }
    }

    private static (Action Sleep, Action Wake) OnFutex(long period)
    {
        var word = new FutexWord();
        long deadline = MonotonicClock.Now;
        return (() => word.WaitUntil(deadline += period), word.Set);
    }

    private static (Action Sleep, Action Wake) OnSemaphore(TimeSpan period)
    {
        var signal = new SemaphoreSlim(0);
        return (() => signal.Wait(period), () => signal.Release());
    }
}
