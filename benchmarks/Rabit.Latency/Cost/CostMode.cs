using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Latency.Idle;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Latency.Reporting;
using Rabit.Latency.Soak;

namespace Rabit.Latency.Cost;

/// <summary>What managers and messages cost by their number: to start, to have, and to stop.</summary>
internal static class CostMode
{
    private static readonly TimeSpan Period = TimeSpan.FromSeconds(1);

    public static IReadOnlyList<Table> Run(RunOptions options) => [OfManagers(options), OfMessages(options)];

    private static Table OfManagers(RunOptions options)
    {
        Subject threads = Managers(
            options, "200 threads on AutoResetEvents", 200, n => BaselineSleepers.OnEvents(Period, n));
        Subject rabit = Managers(options, "200 managers", 200, Rabit);
        int many = options.Pick(300, 1000);
        List<Subject> subjects =
        [
            threads,
            Managers(options, "1 manager", 1, Rabit),
            Managers(options, "30 managers", 30, Rabit),
            rabit,
            Managers(options, $"{many} managers", many, Rabit),
        ];
        Rounds.Run(subjects, options.Pick(1, options.Rounds));
        var table = new Table(
            "cost", "managers that wake once a second and do nothing: made and started; the memory of each; stopped",
            [
                new Column("start ms", hasRatio: false), new Column("stop ms", hasRatio: false),
                new Column("heap B each", "0", hasRatio: false, isGrowth: true),
                new Column("RSS kB each", hasRatio: false, isGrowth: true),
                new Column("% of a core", "0.00", hasRatio: false),
            ],
            subjects, threads, "base");
        table.RequireMax(rabit, 0, 45);
        table.RequireMax(rabit, 1, 10);
        return table;
    }

    private static Sleepers Rabit(int number) => new RabitSleepers(WaitEngine.Best, Period, number);

    private static Subject Managers(RunOptions options, string name, int number, Func<int, Sleepers> create)
        => new(name, () =>
        {
            ProcessState before = ProcessState.Now();
            long start = MonotonicClock.Now;
            Sleepers sleepers = create(number);
            long started = MonotonicClock.Now;
            MonotonicClock.SleepMilliseconds(100);   // until they sleep
            double load = CpuLoad.During(options.Pick(0.2, 1.0));
            ProcessState with = ProcessState.Now();
            long stop = MonotonicClock.Now;
            sleepers.Dispose();
            long stopped = MonotonicClock.Now;
            MonotonicClock.SleepMilliseconds(100);   // until its threads have exited: the next subject has the CPUs
            return
            [
                (started - start) / 1e6,
                (stopped - stop) / 1e6,
                (with.HeapBytes - before.HeapBytes) / (double)number,
                (with.ResidentBytes - before.ResidentBytes) / 1024.0 / number,
                load,
            ];
        });

    private static Table OfMessages(RunOptions options)
    {
        int many = options.Pick(1000, 10_000);
        List<Subject> subjects =
        [
            Messages("1 message", 1),
            Messages("100 messages", 100),
            Messages($"{many} messages", many),
        ];
        Rounds.Run(subjects, options.Pick(1, options.Rounds));
        return new Table(
            "cost", "messages of 72 bytes from one manager to another: wired and started; the memory of each; a post, "
                + "to all in turn",
            [
                new Column("start ms", hasRatio: false),
                new Column("heap B each", "0", hasRatio: false, isGrowth: true),
                new Column("post ns", hasRatio: false),
            ],
            subjects);
    }

    private static Subject Messages(string name, int number) => new(name, () =>
    {
        ProcessState before = ProcessState.Now();
        long start = MonotonicClock.Now;
        using var messages = new ManyMessages(number);
        double started = (MonotonicClock.Now - start) / 1e6;
        ProcessState with = ProcessState.Now();
        return [started, (with.HeapBytes - before.HeapBytes) / (double)number, messages.PostAll()];
    });
}
