using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Latency.Idle;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Latency.Reporting;

namespace Rabit.Latency.Supervision;

/// <summary>How long sixteen managers take to stop that would sleep for ten seconds.</summary>
internal static class StopMode
{
    private static readonly TimeSpan Long = TimeSpan.FromSeconds(10);

    public static Table Run(RunOptions options)
    {
        Subject baseline = Row("AutoResetEvent", () => BaselineSleepers.OnEvents(Long));
        Subject futex = Row(RabitRun.NameOf(WaitEngine.Futex), () => new RabitSleepers(WaitEngine.Futex, Long));
        Subject byEvent = Row(RabitRun.NameOf(WaitEngine.Event), () => new RabitSleepers(WaitEngine.Event, Long));
        List<Subject> subjects = [baseline, futex, byEvent];
        Rounds.Run(subjects, options.Pick(1, options.Rounds));
        var table = new Table(
            "stop", "sixteen threads with timers of 10 s are stopped", [new Column("ms", "0.00")], subjects, baseline,
            "base");
        table.RequireMax(futex, 0, 50);
        table.RequireMax(byEvent, 0, 50);
        return table;
    }

    private static Subject Row(string name, Func<Sleepers> create) => new(name, () =>
    {
        Sleepers sleepers = create();
        MonotonicClock.SleepMilliseconds(50);   // until they sleep
        long start = MonotonicClock.Now;
        sleepers.Dispose();
        return [(MonotonicClock.Now - start) / 1e6];
    });
}
