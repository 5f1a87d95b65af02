using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.Linq;
using Rabit.Core;

namespace Rabit.Benchmarks.Core.Queues;

/// <summary>
/// The queues beside their peers by a stopwatch: all contenders take turns in every round, so that what else the machine does meets all of
/// them; the median of the rounds, and the median of the ratios to the channel in the same round.
/// </summary>
internal static class QueueSpeed
{
    private const int Capacity = 1024;

    private const int Together = 20_000;

    public static void Run(int rounds)
    {
        OneThreadTable<int>("int", rounds);
        OneThreadTable<Block64>("64 bytes", rounds);
        foreach (int senders in new[] { 1, 2 })
        {
            FlatOutTable<int>("int", senders, rounds);
            FlatOutTable<Block64>("64 bytes", senders, rounds);
        }
    }

    private static void OneThreadTable<T>(string what, int rounds)
        where T : struct
        => Measure($"push and pop, one thread, {what}: ns", rounds * 10, Together, perSecond: false,
        [
            new OneThread<T, ChannelPeer<T>>("Channel", new ChannelPeer<T>(Capacity, 1)),
            new RabitOneThread<T>("Rabit, reject", Capacity, QueueFullMode.Reject),
            new RabitTwoManagers<T>("Rabit, two managers", Together),
            new RabitOneThread<T>("Rabit, drop oldest", Capacity, QueueFullMode.DropOldest),
            new RabitOneThread<T>("Rabit, drop newest", Capacity, QueueFullMode.DropNewest),
            new OneThread<T, ConcurrentQueuePeer<T>>("ConcurrentQueue", new ConcurrentQueuePeer<T>()),
            new OneThread<T, BlockingCollectionPeer<T>>("BlockingCollection", new BlockingCollectionPeer<T>(Capacity)),
            new OneThread<T, LockPeer<T>>("lock by hand", new LockPeer<T>(Capacity)),
            new OneThread<T, SpscPeer<T>>("SPSC ring", new SpscPeer<T>(Capacity)),
        ]);

    private static void FlatOutTable<T>(string what, int senders, int rounds)
        where T : struct
    {
        var contenders = new List<IContender>
        {
            new FlatOut<T, ChannelPeer<T>>("Channel", senders, new ChannelPeer<T>(Capacity, senders)),
            new RabitFlatOut<T>("Rabit, reject", senders, Capacity, QueueFullMode.Reject),
            new FlatOut<T, ConcurrentQueuePeer<T>>("ConcurrentQueue", senders, new ConcurrentQueuePeer<T>()),
            new FlatOut<T, BlockingCollectionPeer<T>>("BlockingCollection", senders, new BlockingCollectionPeer<T>(Capacity)),
            new FlatOut<T, LockPeer<T>>("lock by hand", senders, new LockPeer<T>(Capacity)),
        };
        if (senders == 1)
            contenders.Add(new FlatOut<T, SpscPeer<T>>("SPSC ring", senders, new SpscPeer<T>(Capacity)));
        Measure($"{senders} sender(s), 1 receiver, {what}: M/s", rounds, messages: 200_000, perSecond: true, contenders);
    }

    private static void Measure(string title, int rounds, int messages, bool perSecond, List<IContender> contenders)
    {
        double[][] nanoseconds = [.. contenders.Select(_ => new double[rounds])];
        for (int round = -2; round < rounds; round++)
        {
            for (int i = 0; i < contenders.Count; i++)
            {
                long begin = Stopwatch.GetTimestamp();
                contenders[i].Transfer(messages);
                if (round >= 0)
                    nanoseconds[i][round] = Stopwatch.GetElapsedTime(begin).TotalNanoseconds / messages;
            }
        }

        Console.WriteLine(title);
        for (int i = 0; i < contenders.Count; i++)
        {
            double median = Median(nanoseconds[i]);
            double toChannel = Median([.. nanoseconds[i].Zip(nanoseconds[0], (mine, channel) => mine / channel)]);
            string figure = (perSecond ? 1000 / median : median).ToString("F1", CultureInfo.InvariantCulture);
            string ratio = (perSecond ? 1 / toChannel : toChannel).ToString("F2", CultureInfo.InvariantCulture);
            Console.WriteLine($"  {contenders[i].Name,-20} {figure,8}   {ratio,6} x Channel");
            contenders[i].Dispose();
        }
    }

    private static double Median(double[] values)
    {
        double[] sorted = [.. values.Order()];
        return sorted[sorted.Length / 2];
    }
}
