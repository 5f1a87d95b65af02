using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using Rabit.Core.Queues;
using Rabit.Core.WakeUp;
using Xunit;

namespace Rabit.Core.Tests.Queues;

/// <summary>
/// Contract 3.1 with real threads: senders and a receiver flat out, and a thread that reads the counters all the while.
/// </summary>
[Trait("Category", "Stress")]
public sealed class QueueStressTests
{
    // On a busy machine a sender may come to its turn late; all of them must have been there.
    private const int MinEach = 500;
    private static readonly TimeSpan Duration = TimeSpan.FromMilliseconds(300);

    public static IEnumerable<object[]> Kinds()
        => from kind in new[]
        {
            QueueKinds.Pair, QueueKinds.Ring, QueueKinds.Rejects, QueueKinds.DropsOldest, QueueKinds.DropsNewest
        }
           from capacity in new[] { 1, 3, 64 }
           select new object[] { kind, capacity };

    [Theory, Trait("Clause", "3.1")]
    [MemberData(nameof(Kinds))]
    public void Queue_SendersAndReceiverFlatOut_LosesNothingAndCountsAll(string kind, int capacity)
    {
        // The ring positions wrap round on the way.
        MessageQueue<Entry, SyncPoints> queue = QueueKinds.Create<Entry>(
            kind, capacity, new WakeUpEvent(), start: -1000);
        bool drops = queue.FullMode != QueueFullMode.Reject;
        var faults = new List<string>();
        long[] putIn = new long[kind == QueueKinds.Pair ? 1 : 3];
        int sending = putIn.Length;
        var threads = new List<Thread>();
        for (int s = 0; s < putIn.Length; s++)
        {
            int sender = s;
            threads.Add(new Thread(() =>
            {
                putIn[sender] = Send(queue, sender);
                Interlocked.Decrement(ref sending);
            }));
        }

        long[] received = new long[putIn.Length];
        threads.Add(new Thread(() => Receive(queue, received, drops, faults, ref sending)));
        threads.Add(new Thread(() => ReadCounters(queue, faults, ref sending)));

        foreach (Thread thread in threads)
            thread.Start();
        foreach (Thread thread in threads)
            thread.Join();

        Assert.Empty(faults);
        QueueCounters counters = queue.Counters;
        Assert.Equal(putIn.Sum(), counters.Pushed);
        Assert.Equal(received.Sum(), counters.Popped);
        Assert.Equal((counters.Pushed - counters.Popped, 0), (counters.Dropped, counters.Resident));
        Assert.InRange(counters.HighWater, 1, capacity);
        if (!drops)
            Assert.Equal(putIn, received);
    }

    private static long Send(MessageQueue<Entry, SyncPoints> queue, int sender)
    {
        long next = 0;
        var batch = new Entry[3];
        var watch = Stopwatch.StartNew();
        while (next < MinEach || watch.Elapsed < Duration)
        {
            if (next % 7 != 0)
            {
                if (queue.Push(new Entry(sender, next)) != PushResult.Rejected)
                    next++;
                else
                    Thread.Yield();
                continue;
            }

            for (int i = 0; i < batch.Length; i++)
                batch[i] = new Entry(sender, next + i);
            int pushed = queue.PushFrom(batch);
            next += pushed;
            if (pushed == 0)
                Thread.Yield();
        }

        return next;
    }

    private static void Receive(
        MessageQueue<Entry, SyncPoints> queue, long[] received, bool drops, List<string> faults, ref int sending)
    {
        long[] next = new long[received.Length];
        var batch = new Entry[5];
        while (true)
        {
            // Before the check: what is sent after it is seen by the next.
            bool isLast = Volatile.Read(ref sending) == 0;
            int popped = 0;
            if (queue.TryPop(out batch[0]))
                popped = 1 + queue.PopInto(batch.AsSpan(1));
            for (int i = 0; i < popped; i++)
            {
                Entry entry = batch[i];
                if (entry.Check != Entry.CheckOf(entry.Sender, entry.Number))
                    Add(faults, $"torn: {entry.Sender}, {entry.Number}");
                else if (entry.Number < next[entry.Sender] || (!drops && entry.Number > next[entry.Sender]))
                    Add(faults, $"{entry.Number} of {entry.Sender} instead of {next[entry.Sender]}");
                next[entry.Sender] = entry.Number + 1;
                received[entry.Sender]++;
            }

            if (popped == 0 && isLast)
                return;
            if (popped == 0)
                Thread.Yield();
        }
    }

    private static void ReadCounters(MessageQueue<Entry, SyncPoints> queue, List<string> faults, ref int sending)
    {
        long popped = 0;
        while (Volatile.Read(ref sending) > 0)
        {
            QueueCounters counters = queue.Counters;
            if (counters.Pushed != counters.Popped + counters.Dropped + counters.Resident || counters.Resident < 0
                || counters.Resident > counters.Capacity || counters.Popped < popped)
                Add(faults, $"counters: {counters.Pushed} pushed, {counters.Popped} popped, {counters.Dropped} "
                    + $"dropped, {counters.Resident} resident");
            popped = counters.Popped;
            Thread.Yield();
        }
    }

    private static void Add(List<string> faults, string fault)
    {
        lock (faults)
        {
            if (faults.Count < 10)
                faults.Add(fault);
        }
    }

    private readonly struct Entry(int sender, long number)
    {
        public readonly int Sender = sender;
        public readonly long Number = number;
        public readonly long Check = CheckOf(sender, number);

        public static long CheckOf(int sender, long number) => unchecked((number * 31) + sender + 1);
    }
}
