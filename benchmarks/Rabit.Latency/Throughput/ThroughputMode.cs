using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Threading.Channels;
using Rabit.Latency.Measuring;
using Rabit.Latency.Reporting;

namespace Rabit.Latency.Throughput;

/// <summary>How many messages per second a queue carries between threads that do nothing else.</summary>
internal static class ThroughputMode
{
    private const int Capacity = 1024;
    private const int WarmUps = 120;
    private const int MessagesOfWarmUp = 10_000;

    public static IReadOnlyList<Table> Run(RunOptions options) =>
    [
        Run<int>(options, 1, "int", 80, 413, 5),
        Run<Block64>(options, 1, "64 bytes", 40, 97, 5),
        Run<int>(options, 2, "int", 30, 49, 2.5),
        Run<Block64>(options, 2, "64 bytes", 20, 28, 2.5),
    ];

    private static Table Run<T>(
        RunOptions options, int senders, string what, double least, double baseline, double timesChannel)
        where T : struct
    {
        int fast = options.Pick(100_000, 4_000_000);
        int slow = options.Pick(20_000, 1_000_000);
        var flow = new RabitFlow<T>(senders, Capacity);
        Subject rabit = Row("Rabit, reject", fast, flow.Run).Owning(flow);
        Subject channel = Row(
            "Channel, bounded", slow,
            n => BaselineFlow.Run<BaselineQueues.ChannelEnds<T>, T>(new(NewChannel<T>(senders)), senders, n));
        Subject limit = senders == 1
            ? Row(
                "SPSC ring", fast,
                n => BaselineFlow.Run<BaselineQueues.Single<T>, T>(new(new SpscRing<T>(Capacity)), senders, n))
            : Row(
                "MPSC ring", fast,
                n => BaselineFlow.Run<BaselineQueues.Multi<T>, T>(new(new MpscRing<T>(Capacity)), senders, n));
        var subjects = new List<Subject>
        {
            limit,
            rabit,
            channel,
            Row(
                "ConcurrentQueue, unbounded", fast,
                n => BaselineFlow.Run<BaselineQueues.Concurrent<T>, T>(new(new ConcurrentQueue<T>()), senders, n)),
            Row("BlockingCollection", slow, n => BaselineFlow.Run<BaselineQueues.Blocking<T>, T>(
                new(new BlockingCollection<T>(Capacity)), senders, n)),
            Row(
                "ring under a lock", fast,
                n => BaselineFlow.Run<BaselineQueues.Locked<T>, T>(new(new LockedRing<T>(Capacity)), senders, n)),
        };
        if (senders == 1)
        {
            subjects.Insert(1, Row(
                "SPSC ring with sequences", fast, n => BaselineFlow.Run<BaselineQueues.Sequenced<T>, T>(
                    new(new SequencedSpscRing<T>(Capacity)), senders, n)));
        }

        Rounds.Run(subjects, options.Pick(1, options.Rounds), warmUps: options.Pick(1, WarmUps));
        rabit.Dispose();
        var table = new Table(
            "throughput",
            $"{senders} sender(s), 1 receiver, {what}, {Capacity} entries, flat out"
                + (senders == 1 ? ", a CPU each" : string.Empty),
            [new Column("M/s")],
            subjects,
            limit);
        table.RequireMin(rabit, 0, least, limit, baseline);
        table.RequireMinRatio(rabit, channel, 0, timesChannel);
        return table;
    }

    private static Channel<T> NewChannel<T>(int senders)
        => Channel.CreateBounded<T>(
            new BoundedChannelOptions(Capacity) { SingleReader = true, SingleWriter = senders == 1 });

    // A warm-up is short: what counts is how often, until the loops around the queues are compiled to the last tier.
    private static Subject Row(string name, int messages, Func<int, double> run)
        => new(name, () => [run(messages)], warmUp: () => run(MessagesOfWarmUp));
}
