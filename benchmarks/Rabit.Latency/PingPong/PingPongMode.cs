using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Latency.Reporting;
using Rabit.Latency.Signals;

namespace Rabit.Latency.PingPong;

/// <summary>How long two managers take that wake each other through queues, on one CPU and on two.</summary>
internal static class PingPongMode
{
    private const int BothWays = 0;

    // By ticks: Mono makes whole milliseconds of a number of them, here none.
    private static readonly TimeSpan MaxSpin = TimeSpan.FromTicks(1000);

    public static Table OnOneCpu(RunOptions options)
    {
        int roundTrips = options.Pick(200, 10_000);
        List<Subject> subjects = Baseline(roundTrips, Cpus.One);
        Subject futex = Row(
            RabitRun.NameOf(WaitEngine.Futex), new RabitPingPong(WaitEngine.Futex, Cpus.One, Cpus.One), roundTrips);
        Subject byEvent = Row(
            RabitRun.NameOf(WaitEngine.Event), new RabitPingPong(WaitEngine.Event, Cpus.One, Cpus.One), roundTrips);
        Table table = Play([.. subjects, futex, byEvent], options, roundTrips, "both on one CPU");
        table.RequireMax(futex, BothWays, 8);
        table.RequireRatio(futex, subjects[0], BothWays, 1.4);
        return table;
    }

    public static Table OnTwoCpus(RunOptions options)
    {
        int roundTrips = options.Pick(200, 10_000);
        List<Subject> subjects = Baseline(roundTrips, Cpus.Other);
        Subject words = Row("two words, spinning", new SpinningPingPong(Cpus.One, Cpus.Other), roundTrips);
        Subject sleeping = Row(
            RabitRun.NameOf(WaitEngine.Futex), new RabitPingPong(WaitEngine.Futex, Cpus.One, Cpus.Other), roundTrips);
        Subject spinning = Row(
            "Rabit, SpinBeforeSleep 100 µs", new RabitPingPong(WaitEngine.Futex, Cpus.One, Cpus.Other, MaxSpin),
            roundTrips);
        Table table = Play([.. subjects, words, sleeping, spinning], options, roundTrips, "each on a CPU of its own");
        table.RequireMax(spinning, BothWays, 0.7);
        return table;
    }

    private static List<Subject> Baseline(int roundTrips, int answererCpu)
    {
        var subjects = new List<Subject>();
        foreach ((string name, Func<Signal> create) in Baselines.All)
            subjects.Add(Row(name, new BaselinePingPong(create, Cpus.One, answererCpu), roundTrips));
        return subjects;
    }

    private static Table Play(List<Subject> subjects, RunOptions options, int roundTrips, string place)
    {
        Rounds.Run(subjects, options.Pick(1, options.Rounds), warmUps: options.Pick(1, 2));
        foreach (Subject subject in subjects)
            subject.Dispose();
        return new Table(
            "pingpong",
            $"two threads wake each other in turn, {place}, {roundTrips} times a round; mean of there and back, and of "
                + "one way",
            [new Column("both µs", "0.00"), new Column("one way µs", "0.00", hasRatio: false)],
            subjects,
            subjects[0]);
    }

    private static Subject Row(string name, PingPongTarget target, int roundTrips)
        => new Subject(name, () => target.Run(roundTrips)).Owning(target);
}
