using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Latency.Reporting;
using Rabit.Latency.Signals;

namespace Rabit.Latency.PingPong;

/// <summary>How long two managers take that wake each other through queues, on one CPU.</summary>
internal static class PingPongMode
{
    private const int BothWays = 0;

    public static Table Run(RunOptions options)
    {
        int roundTrips = options.Pick(200, 10_000);
        var subjects = new List<Subject>();
        foreach ((string name, Func<Signal> create) in Baselines.All)
            subjects.Add(Row(name, new BaselinePingPong(create, Cpus.One), roundTrips));
        Subject futex = Row(
            RabitRun.NameOf(WaitEngine.Futex), new RabitPingPong(WaitEngine.Futex, Cpus.One), roundTrips);
        Subject byEvent = Row(
            RabitRun.NameOf(WaitEngine.Event), new RabitPingPong(WaitEngine.Event, Cpus.One), roundTrips);
        subjects.Add(futex);
        subjects.Add(byEvent);

        Rounds.Run(subjects, options.Pick(1, options.Rounds), warmUps: options.Pick(1, 2));
        foreach (Subject subject in subjects)
            subject.Dispose();

        var table = new Table(
            "pingpong",
            $"two threads wake each other in turn, both on one CPU, {roundTrips} times a round; mean of there and "
                + "back, and of one way",
            [new Column("both µs", "0.00"), new Column("one way µs", "0.00", hasRatio: false)],
            subjects,
            subjects[0]);
        table.RequireMax(futex, BothWays, 8);
        table.RequireRatio(futex, subjects[0], BothWays, 1.4);
        return table;
    }

    private static Subject Row(string name, PingPongTarget target, int roundTrips)
        => new Subject(name, () => target.Run(roundTrips)).Owning(target);
}
