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
    private const string ChannelName = "Channel, bounded";

    // What a queue between managers must reach of a hand-written ring, which neither checks, counts nor closes.
    private const double PartOfLimit = 0.9;

    public static IReadOnlyList<Table> Run(RunOptions options) =>
    [
        OfOneSender<int>(options, "int"),
        OfOneSender<Block64>(options, "64 bytes"),
        OfTwoSenders<int>(options, "int", 30, 49),
        OfTwoSenders<Block64>(options, "64 bytes", 20, 28),
        .. WakingThroughput.Run(options),
    ];

    /// <param name="name">The row's name.</param>
    /// <param name="messages">How many in a round.</param>
    /// <param name="run">Carries so many, and gives millions per second.</param>
    // A warm-up is short: what counts is how often, until the loops around the queues are compiled to the last tier.
    public static Subject Row(string name, int messages, Func<int, double> run)
        => new(name, () => [run(messages)], warmUp: () => run(MessagesOfWarmUp));

    public static void Measure(RunOptions options, IReadOnlyList<Subject> subjects)
        => Rounds.Run(subjects, options.Pick(1, options.Rounds), warmUps: options.Pick(1, WarmUps));

    public static Channel<T> NewChannel<T>(int senders)
        => Channel.CreateBounded<T>(
            new BoundedChannelOptions(Capacity) { SingleReader = true, SingleWriter = senders == 1 });

    private static Table OfOneSender<T>(RunOptions options, string what)
        where T : struct
    {
        int fast = options.Pick(100_000, 4_000_000);
        using var flow = new RabitFlow<T>(1, Capacity);
        Subject rabit = Row("Rabit, reject", fast, flow.Run);
        Subject batches = Row($"Rabit, reject, {Flow.BatchSize} at a time", fast, flow.RunBatches);
        Subject ring = Row("SPSC ring", fast, n => BaselineFlow.Run<BaselineQueues.Single<T>, T>(
            new(new SpscRing<T>(Capacity)), 1, n));
        Subject sequenced = Row("SPSC ring with sequences", fast, n => BaselineFlow.Run<BaselineQueues.Sequenced<T>, T>(
            new(new SequencedSpscRing<T>(Capacity)), 1, n));
        Subject ringBatches = Row(
            $"SPSC ring, {Flow.BatchSize} at a time", fast, n => BaselineFlow.RunBatches<BaselineQueues.Single<T>, T>(
                new(new SpscRing<T>(Capacity)), 1, n));
        List<Subject> subjects = [ring, sequenced, rabit, ringBatches, batches, .. Peers<T>(options, 1)];
        Measure(options, subjects);

        // Which of the two is faster depends on how long a cache line takes between the processors of the machine.
        Subject limit = sequenced.Columns[0].Median > ring.Columns[0].Median ? sequenced : ring;
        Table table = TableOf(1, what, ", a CPU each", subjects, limit);
        table.RequireMinRatio(rabit, limit, 0, PartOfLimit);
        table.RequireMinRatio(batches, ringBatches, 0, PartOfLimit);
        table.RequireMinRatio(rabit, ChannelOf(subjects), 0, 5);
        return table;
    }

    private static Table OfTwoSenders<T>(RunOptions options, string what, double least, double limitThere)
        where T : struct
    {
        int fast = options.Pick(100_000, 4_000_000);
        using var flow = new RabitFlow<T>(2, Capacity);
        Subject rabit = Row("Rabit, reject", fast, flow.Run);
        Subject batches = Row($"Rabit, reject, {Flow.BatchSize} at a time", fast, flow.RunBatches);
        Subject limit = Row("MPSC ring", fast, n => BaselineFlow.Run<BaselineQueues.Multi<T>, T>(
            new(new MpscRing<T>(Capacity)), 2, n));
        List<Subject> subjects = [limit, rabit, batches, .. Peers<T>(options, 2)];
        Measure(options, subjects);
        Table table = TableOf(2, what, string.Empty, subjects, limit);
        table.RequireMin(rabit, 0, least, limit, limitThere);
        table.RequireMinRatio(rabit, ChannelOf(subjects), 0, 2.5);
        return table;
    }

    private static Subject ChannelOf(List<Subject> subjects) => subjects.Find(s => s.Name == ChannelName)!;

    private static Subject[] Peers<T>(RunOptions options, int senders)
        where T : struct
    {
        int fast = options.Pick(100_000, 4_000_000);
        int slow = options.Pick(20_000, 500_000);
        return
        [
            Row(ChannelName, slow, n => BaselineFlow.Run<BaselineQueues.ChannelEnds<T>, T>(
                new(NewChannel<T>(senders)), senders, n)),
            Row("ConcurrentQueue, unbounded", fast, n => BaselineFlow.Run<BaselineQueues.Concurrent<T>, T>(
                new(new ConcurrentQueue<T>()), senders, n)),
            Row("BlockingCollection", slow, n => BaselineFlow.Run<BaselineQueues.Blocking<T>, T>(
                new(new BlockingCollection<T>(Capacity)), senders, n)),
            Row("ring under a lock", slow, n => BaselineFlow.Run<BaselineQueues.Locked<T>, T>(
                new(new LockedRing<T>(Capacity)), senders, n)),
        ];
    }

    private static Table TableOf(int senders, string what, string how, List<Subject> subjects, Subject limit)
        => new(
            "throughput",
            $"{senders} sender(s), 1 receiver, {what}, {Capacity} entries, flat out{how}",
            [new Column("M/s")],
            subjects,
            limit);
}
