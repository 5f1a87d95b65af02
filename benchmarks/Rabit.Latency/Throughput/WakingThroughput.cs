using System.Collections.Concurrent;
using System.Collections.Generic;
using Rabit.Latency.Measuring;
using Rabit.Latency.Reporting;

namespace Rabit.Latency.Throughput;

/// <summary>
/// How many messages per second a queue carries to a receiver that sleeps whenever there is nothing, and is woken.
/// </summary>
internal static class WakingThroughput
{
    private const int Capacity = 1024;
    private const double PartOfLimit = 0.9;

    public static IReadOnlyList<Table> Run(RunOptions options) => [Run(options, senders: 1), Run(options, senders: 2)];

    private static Table Run(RunOptions options, int senders)
    {
        int fast = options.Pick(100_000, 4_000_000);
        int slow = options.Pick(20_000, 500_000);
        using var flow = new RabitWakingFlow<int>(senders, Capacity);
        using var waker = new RingWaker();
        Subject rabit = ThroughputMode.Row("Rabit, reject, wakes its receiver", fast, flow.Run);
        Subject limit = senders == 1
            ? ThroughputMode.Row(
                "SPSC ring that wakes by a futex", fast,
                n => RunRing(new BaselineQueues.Single<int>(new SpscRing<int>(Capacity)), waker, senders, n))
            : ThroughputMode.Row(
                "MPSC ring that wakes by a futex", fast,
                n => RunRing(new BaselineQueues.Multi<int>(new MpscRing<int>(Capacity)), waker, senders, n));
        List<Subject> subjects =
        [
            limit,
            rabit,
            ThroughputMode.Row(
                "Channel, bounded", slow,
                n => BaselineFlow.RunWaking<WakingQueues.ChannelEnds<int>, int>(
                    new(ThroughputMode.NewChannel<int>(senders)), senders, n)),
            ThroughputMode.Row(
                "BlockingCollection", slow,
                n => BaselineFlow.RunWaking<WakingQueues.Blocking<int>, int>(
                    new(new BlockingCollection<int>(Capacity)), senders, n)),
            ThroughputMode.Row(
                "ring under a lock, Wait and Pulse", slow,
                n => BaselineFlow.RunWaking<WakingQueues.Locked<int>, int>(
                    new(new LockedRing<int>(Capacity)), senders, n)),
        ];
        ThroughputMode.Measure(options, subjects);
        var table = new Table(
            "throughput",
            $"{senders} sender(s), 1 receiver that sleeps while there is nothing and is woken, int, "
                + $"{Capacity} entries, flat out" + (senders == 1 ? ", a CPU each" : string.Empty),
            [new Column("M/s")],
            subjects,
            limit);
        table.RequireMinRatio(rabit, limit, 0, PartOfLimit);
        return table;
    }

    private static double RunRing<TEnds>(TEnds ring, RingWaker waker, int senders, int messages)
        where TEnds : struct, IPush<int>, IPop<int>
        => BaselineFlow.RunWaking<WakingQueues.Ring<TEnds, int>, int>(new(ring, waker), senders, messages);
}
