using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core.Queues;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Queues;

/// <summary>Contract 3.1: every kind of queue, with every rule, against a sequential model, step by step.</summary>
public sealed class QueueModelTests
{
    private const int Steps = 4000;
    private const int BaseSeed = 20261121;

    public static IEnumerable<object[]> Kinds()
        => from kind in new[]
        {
            QueueKinds.Pair, QueueKinds.Ring, QueueKinds.Rejects, QueueKinds.DropsOldest, QueueKinds.DropsNewest,
            QueueKinds.Waits
        }
           from capacity in new[] { 1, 2, 3, 4, 5, 7, 8, 9, 100 }
           select new object[] { kind, capacity };

    [Theory, Trait("Clause", "3.1")]
    [MemberData(nameof(Kinds))]
    public void Queue_RandomSteps_DoesWhatTheModelDoes(string kind, int capacity)
    {
        // The ring positions begin shortly before they wrap round, or before their top bit changes.
        foreach (int start in new[] { 0, -50, int.MaxValue - 50 })
        {
            int seed = unchecked((BaseSeed * capacity) + start);
            try
            {
                Walk(
                    QueueKinds.Create<int>(kind, capacity, receiver: null, start),
                    new QueueModel(capacity, QueueKinds.RuleOf(kind)), seed);
            }
            catch (Exception e)
            {
                throw new InvalidOperationException(
                    string.Format(
                        CultureInfo.InvariantCulture, "{0}, capacity {1}, start {2}, seed {3}: {4}", kind, capacity,
                        start, seed, e.Message),
                    e);
            }
        }
    }

    [Theory, Trait("Clause", "3.1")]
    [InlineData(QueueKinds.Pair)]
    [InlineData(QueueKinds.Ring)]
    public void Counters_PositionsWrapRound_GoOnCounting(string kind)
    {
        // The positions start where they have been after 2^31 values and wrap after ten more; the counters count from
        // the start.
        foreach (int start in new[] { int.MaxValue - 10, -10 })
        {
            MessageQueue<int, SyncPoints> queue = QueueKinds.Create<int>(kind, 4, receiver: null, start);
            for (int i = 0; i < 40; i++)
            {
                Assert.Equal(PushResult.Queued, queue.Push(i));
                Assert.Equal((i + 1L, i, 1), (queue.Counters.Pushed, queue.Counters.Popped, queue.Counters.Resident));
                Assert.True(queue.TryPop(out int value));
                Assert.Equal(i, value);
                Assert.Equal(
                    (i + 1L, i + 1L, 0), (queue.Counters.Pushed, queue.Counters.Popped, queue.Counters.Resident));
            }
        }
    }

    [Theory, Trait("Clause", "3.2")]
    [InlineData(QueueKinds.Pair)]
    [InlineData(QueueKinds.Ring)]
    [InlineData(QueueKinds.Rejects)]
    [InlineData(QueueKinds.DropsOldest)]
    public void Push_Each_WakesUnlessAWakeIsPending(string kind)
    {
        var receiver = new WakeUpEvent();
        var sender = new WakeUpEvent();
        MessageQueue<int, SyncPoints> queue = QueueKinds.Create<int>(kind, 3, receiver);
        queue.AddPopTarget(sender);

        for (int round = 0; round < 3; round++)
        {
            Assert.False(receiver.Has((int)WakeUpCauses.Push));
            queue.Push(1);
            Assert.Equal(WakeUpCauses.Push, receiver.Consume().Causes);
            queue.PushFrom([2, 3]);
            Assert.Equal(WakeUpCauses.Push, receiver.Consume().Causes);
            bool drops = queue.Push(4) != PushResult.Rejected;
            Assert.Equal(drops ? WakeUpCauses.Push : WakeUpCauses.None, receiver.Consume().Causes);
            Assert.Equal(drops ? 3 : 0, queue.PushFrom([5, 6, 7]));
            Assert.Equal(drops ? WakeUpCauses.Push : WakeUpCauses.None, receiver.Consume().Causes);

            Assert.False(sender.Has((int)WakeUpCauses.Pop));
            queue.TryPop(out _);
            Assert.Equal(WakeUpCauses.Pop, sender.Consume().Causes);
            Assert.Equal(2, queue.PopInto(new int[5]));
            Assert.Equal(WakeUpCauses.Pop, sender.Consume().Causes);
            Assert.False(queue.TryPop(out _));
            Assert.Equal(0, queue.PopInto(new int[5]));
            Assert.Equal(WakeUpCauses.None, sender.Consume().Causes);
        }
    }

    [Theory, Trait("Clause", "3.1")]
    [InlineData(QueueKinds.Pair, false)]
    [InlineData(QueueKinds.Pair, true)]
    [InlineData(QueueKinds.Ring, false)]
    [InlineData(QueueKinds.Ring, true)]
    [InlineData(QueueKinds.Rejects, false)]
    [InlineData(QueueKinds.Rejects, true)]
    public void Pop_ValueWithReferences_IsNotKeptAlive(string kind, bool several)
    {
        MessageQueue<object, SyncPoints> queue = QueueKinds.Create<object>(kind, 4);
        WeakReference popped = PushAndPop(queue, several);
        for (int i = 0; i < 10 && popped.IsAlive; i++)
        {
            // Mono looks at its stack conservatively: new frames over the old ones.
            ScrubStack(500);
            GC.Collect();
            GC.WaitForPendingFinalizers();
        }

        Assert.False(popped.IsAlive);
        GC.KeepAlive(queue);
    }

    private static WeakReference PushAndPop(MessageQueue<object, SyncPoints> queue, bool several)
    {
        WeakReference reference = null!;
        var thread = new Thread(() =>
        {
            reference = new WeakReference(new object());
            queue.Push(reference.Target!);
            if (several)
                queue.PopInto(new object[2]);
            else
                queue.TryPop(out _);
        });
        thread.Start();
        thread.Join();
        return reference;
    }

    private static int ScrubStack(int depth) => depth == 0 ? 0 : 1 + ScrubStack(depth - 1);

    private static void Walk(MessageQueue<int, SyncPoints> queue, QueueModel model, int seed)
    {
        var random = new SplitMix64(unchecked((ulong)seed));
        var pending = new List<Task<PushResult>>();
        int next = 1;
        for (int step = 0; step < Steps; step++)
        {
            // Now rather fuller, now rather emptier.
            bool pushes = random.Next(10) < (step / 200 % 2 == 0 ? 6 : 4);
            switch (random.Next(4))
            {
                case 0 when pushes:
                    int[] values = Enumerable.Range(next, random.Next(6)).ToArray();
                    next += values.Length;
                    Assert.Equal(model.PushFrom(values), queue.PushFrom(values));
                    break;
                case 1 when pushes && queue is LockedQueue<int> { FullMode: QueueFullMode.Wait } waiting:
                    pending.Add(waiting.PushAsync(next, CancellationToken.None).AsTask());
                    model.PushOrWait(next++);
                    break;
                case var _ when pushes:
                    Assert.Equal(model.Push(next), queue.Push(next));
                    next++;
                    break;
                case 0:
                    int[] target = new int[random.Next(6)];
                    int popped = queue.PopInto(target);
                    Assert.Equal(model.PopUpTo(target.Length), target.Take(popped));
                    break;
                default:
                    Assert.Equal(model.TryPop(out int expected), queue.TryPop(out int value));
                    Assert.Equal(expected, value);
                    break;
            }

            QueueCounters counters = queue.Counters;
            Assert.Equal(model.Counters, (counters.Pushed, counters.Popped, counters.Dropped, counters.Rejected,
                counters.Resident, counters.HighWater));
            Assert.Equal(counters.Pushed, counters.Popped + counters.Dropped + counters.Resident);
            Assert.Equal(counters.Resident, queue.Count);
        }

        while (queue.TryPop(out int value))
        {
            Assert.True(model.TryPop(out int expected));
            Assert.Equal(expected, value);
        }

        Assert.Equal(0, model.Waiting);
        Assert.True(Task.WaitAll(pending.ToArray<Task>(), TestTimeout.Limit));
        Assert.All(pending, push => Assert.Equal(PushResult.Queued, push.Result));
    }
}
