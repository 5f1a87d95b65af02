using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Latency.Measuring;
using Rabit.Latency.Reporting;

namespace Rabit.Latency.Calls;

/// <summary>What single calls cost on one thread, on both runtimes, and that they allocate nothing.</summary>
internal static class CallsMode
{
    private const int Nanoseconds = 0;
    private const int Collections = 1;

    private static readonly bool IsMono = Type.GetType("Mono.Runtime") is not null;

    public static IReadOnlyList<Table> Run(RunOptions options)
    {
        int calls = options.Pick(20_000, 10_000_000);
        RabitReactor reactor = RabitRun.Create(WaitEngine.Best);
        var manager = new CallManager(reactor.Workspace);
        reactor.Add(manager);
        reactor.Start();
        var hand = new BaselineCalls();
        Table[] tables =
        [
            Measure(
                options, "fetch, nothing new", calls,
                new("a volatile read in a call", () => hand.FetchUnchanged(calls)),
                new("Rabit", () => manager.FetchUnchanged(calls)), null, IsMono ? (8, 3.4) : (3, 2.3)),
            Measure(
                options, "post, given the time, and the fetch that sees it: 72 bytes", calls,
                new("lock and version", () => hand.PostAndFetch(calls)),
                new("Rabit", () => manager.PostAndFetch(calls)), null, IsMono ? (100, 67) : (28, 21.5)),
            Measure(options, "push and pop, 64 bytes", calls, new("MPSC ring", () => hand.PushAndPopRing(calls)),
                new("Rabit, a queue of one's own", () => manager.PushAndPop(calls)),
                new("ConcurrentQueue", () => hand.PushAndPopConcurrentQueue(calls)), IsMono ? (50, 28) : (14, 6.1)),
        ];
        RabitRun.End(reactor);
        manager.Dispose();
        return tables;
    }

    private static Table Measure(
        RunOptions options, string what, int calls, Subject baseline, Subject rabit, Subject? peer,
        (double Required, double ByHandThere) limit)
    {
        List<Subject> subjects = [baseline, rabit];
        if (peer is not null)
            subjects.Add(peer);
        Rounds.Run(subjects, options.Pick(1, options.Rounds), warmUps: options.Pick(1, 2));
        var table = new Table(
            "calls", $"{what}; one thread, {calls} a round",
            [new Column("ns"), new Column("collections", "0", hasRatio: false)], subjects, baseline, "baseline");
        table.RequireMax(rabit, Nanoseconds, limit.Required, baseline, limit.ByHandThere);
        table.RequireMax(rabit, Collections, 0);
        return table;
    }
}
