using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 3: the message queue.</summary>
public abstract class QueueContract(TimeKind kind) : ContractTests(kind)
{
    [Fact, Trait("Clause", "3.1")]
    public void Queue_ManySenders_IsFirstInFirstOutPerSenderAndLosesNothing()
    {
        const int Each = 2000;
        using TestRun run = NewRun();
        ScriptedManager sink = run.Add("sink");
        QueueReceiver<(int Sender, int Number)> receiver = sink.Receive<(int Sender, int Number)>(
            "queue", capacity: 3 * Each);
        var senders = new List<ScriptedManager>();
        for (int s = 0; s < 3; s++)
        {
            int number = s;
            ScriptedManager source = run.Add("source " + s);
            QueueSender<(int Sender, int Number)> sender = source.Send<(int Sender, int Number)>("queue");
            source.OnUnit = () =>
            {
                for (int i = 0; source.Units == 1 && i < Each; i++)
                    Assert.Equal(PushResult.Queued, sender.Push((number, i)));
            };
            senders.Add(source);
        }

        int[] next = new int[3];
        sink.OnUnit = () =>
        {
            while (receiver.TryPop(out (int Sender, int Number) value))
                Assert.Equal(next[value.Sender]++, value.Number);
            if (next.All(n => n == Each))
                run.Board.Write("complete");
        };

        run.Start();
        run.Until(() => run.Board.Count("complete") > 0, "every value arrives");
        Assert.Equal(0, run.Finish().ExitCode);
    }

    [Fact, Trait("Clause", "3.1")]
    public void Push_FullQueueRejects_IsRefusedAndCounted()
    {
        using QueuePair pair = Connect(capacity: 2, QueueFullMode.Reject);
        pair.Run.On(pair.Source, () => Assert.Equal(
            [PushResult.Queued, PushResult.Queued, PushResult.Rejected], Push(pair.Sender, 1, 2, 3)));
        pair.Run.On(pair.Sink, () =>
        {
            AssertCounters(pair.Receiver.Counters, pushed: 2, popped: 0, dropped: 0, rejected: 1, resident: 2);
            Assert.Equal([1, 2], PopAll(pair.Receiver));
            AssertCounters(pair.Receiver.Counters, pushed: 2, popped: 2, dropped: 0, rejected: 1, resident: 0);
            Assert.Equal(2, pair.Receiver.Counters.Capacity);
        });
    }

    [Fact, Trait("Clause", "3.1")]
    public void Push_FullQueueDropsOldest_KeepsTheNewestAndCounts()
    {
        using QueuePair pair = Connect(capacity: 2, QueueFullMode.DropOldest);
        pair.Run.On(pair.Source, () =>
        {
            Assert.Equal(
                [PushResult.Queued, PushResult.Queued, PushResult.QueuedDroppedOldest, PushResult.QueuedDroppedOldest],
                Push(pair.Sender, 1, 2, 3, 4));
            AssertCounters(pair.Sender.Counters, pushed: 4, popped: 0, dropped: 2, rejected: 0, resident: 2);
        });
        pair.Run.On(pair.Sink, () =>
        {
            Assert.Equal([3, 4], PopAll(pair.Receiver));
            AssertCounters(pair.Receiver.Counters, pushed: 4, popped: 2, dropped: 2, rejected: 0, resident: 0);
        });
    }

    [Fact, Trait("Clause", "3.1")]
    public void Push_FullQueueDropsNewest_KeepsTheOldestAndTheLast()
    {
        using QueuePair pair = Connect(capacity: 3, QueueFullMode.DropNewest);
        pair.Run.On(pair.Source, () =>
        {
            Assert.Equal(
                [PushResult.Queued, PushResult.Queued, PushResult.Queued, PushResult.QueuedDroppedNewest,
                    PushResult.QueuedDroppedNewest],
                Push(pair.Sender, 1, 2, 3, 4, 5));
            AssertCounters(pair.Sender.Counters, pushed: 5, popped: 0, dropped: 2, rejected: 0, resident: 3);
        });
        pair.Run.On(pair.Sink, () =>
        {
            Assert.Equal([1, 2, 5], PopAll(pair.Receiver));
            AssertCounters(pair.Receiver.Counters, pushed: 5, popped: 3, dropped: 2, rejected: 0, resident: 0);
        });
    }

    [Theory, Trait("Clause", "3.1")]
    [InlineData(QueueFullMode.Reject, 4, new[] { 0, 1, 2, 3 })]
    [InlineData(QueueFullMode.DropOldest, 6, new[] { 2, 3, 4, 5 })]
    [InlineData(QueueFullMode.DropNewest, 6, new[] { 0, 1, 2, 5 })]
    public void PushFrom_MoreThanFits_DoesAsSinglePushesDo(QueueFullMode whenFull, int putIn, int[] left)
    {
        using QueuePair pair = Connect(capacity: 4, whenFull, wakeOnPush: true);
        pair.Run.OnAndSettle(pair.Source, () =>
        {
            Assert.Equal(0, pair.Sender.PushFrom([]));
            Assert.Equal(putIn, pair.Sender.PushFrom([0, 1, 2, 3, 4, 5]));
            AssertCounters(
                pair.Sender.Counters, pushed: putIn, popped: 0, dropped: putIn - 4, rejected: 6 - putIn, resident: 4);
        });
        pair.Run.Until(() => pair.Sink.Units == 2, "the push wakes the sink");
        pair.Run.On(pair.Sink, () =>
        {
            int[] target = new int[3];
            Assert.Equal(3, pair.Receiver.PopInto(target));
            Assert.Equal(left.Take(3), target);
            Assert.Equal(1, pair.Receiver.PopInto(target));
            Assert.Equal(left[3], target[0]);
            Assert.Equal(0, pair.Receiver.PopInto(target));
            Assert.Equal(0, pair.Receiver.PopInto(Span<int>.Empty));
        });
        Assert.Equal(WakeUpCauses.Push, pair.Sink.Causes[1]);
    }

    [Theory, Trait("Clause", "3.1")]
    [InlineData(QueueFullMode.Reject)]
    [InlineData(QueueFullMode.DropOldest)]
    public void Counters_HighWater_IsThePeakOccupancy(QueueFullMode whenFull)
    {
        using QueuePair pair = Connect(capacity: 8, whenFull);
        int[] marks = [0, 0, 0, 0];
        pair.Run.On(pair.Source, () => marks[0] = pair.Sender.Counters.HighWater);
        pair.Run.On(pair.Source, () => Push(pair.Sender, 1, 2, 3));
        pair.Run.On(pair.Sink, () => PopAll(pair.Receiver));
        pair.Run.On(pair.Source, () => marks[1] = pair.Sender.Counters.HighWater);
        pair.Run.On(pair.Source, () => Push(pair.Sender, 1, 2, 3, 4, 5));
        pair.Run.On(pair.Sink, () => marks[2] = pair.Receiver.Counters.HighWater);
        pair.Run.On(pair.Source, () => Push(pair.Sender, Enumerable.Range(0, 20).ToArray()));
        pair.Run.On(pair.Sink, () => marks[3] = pair.Receiver.Counters.HighWater);

        Assert.Equal([0, 3, 5, 8], marks);
    }

    [Theory, Trait("Clause", "3.5")]
    [InlineData(QueueFullMode.Reject)]
    [InlineData(QueueFullMode.DropNewest)]
    public void Finish_ValuesLeftInAQueue_AreReported(QueueFullMode whenFull)
    {
        using QueuePair pair = Connect(capacity: 8, whenFull);
        QueueSender<int> other = pair.Sender;
        pair.Run.On(pair.Source, () => Push(other, 1, 2, 3));
        pair.Run.On(pair.Sink, () => Assert.True(pair.Receiver.TryPop(out _)));
        ReactorResult result = pair.Run.Finish();

        QueueResult queue = Assert.Single(result.Queues);
        Assert.Equal("queue", queue.Name);
        AssertCounters(queue.Counters, pushed: 3, popped: 1, dropped: 0, rejected: 0, resident: 2);
        Assert.Contains("queue queue: 2 values were left", result.ToString(), StringComparison.Ordinal);
        Assert.Contains(pair.Run.Log, e => e.Kind == RabitLogKind.Note && e.Source == "queue"
            && e.Text.Contains("2 values", StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "3.5")]
    public void Finish_EmptyQueue_IsNotAWordInTheLog()
    {
        using QueuePair pair = Connect(capacity: 8, QueueFullMode.Reject);
        ReactorResult result = pair.Run.Finish();

        Assert.Equal(0, Assert.Single(result.Queues).Counters.Resident);
        Assert.DoesNotContain("queue", result.ToString(), StringComparison.Ordinal);
        Assert.DoesNotContain(pair.Run.Log, e => e.Source == "queue");
    }

    [Fact, Trait("Clause", "3.5"), Trait("Clause", "3.1")]
    public void Push_AfterTheRun_IsRejectedAndCounted()
    {
        using TestRun run = NewRun();
        run.Add("sink").Receive<int>("queue", 8, wakeOnPush: false);
        QueueSender<int> outside = run.Reactor.Workspace.Send<int>("queue");
        run.StartAndSettle();
        outside.Push(1);
        run.Finish();

        Assert.Equal(PushResult.Rejected, outside.Push(2));
        Assert.Equal(0, outside.PushFrom([3, 4]));
        AssertCounters(outside.Counters, pushed: 1, popped: 0, dropped: 0, rejected: 3, resident: 1);
        Assert.Equal(1, outside.Counters.HighWater);
    }

    [Fact, Trait("Clause", "3.1"), Trait("Clause", "4.2")]
    public void MaxWait_WithoutSense_IsAWiringFault()
    {
        using TestRun run = NewRun();
        ScriptedManager sink = run.Add("sink");
        sink.Receive<int>("never", whenFull: QueueFullMode.Reject, maxWait: TimeSpan.FromSeconds(1));
        sink.Receive<int>("at once", whenFull: QueueFullMode.Wait, maxWait: TimeSpan.Zero);

        IReadOnlyList<string> faults = Assert.Throws<RabitWiringException>(run.Start).Faults;

        Assert.Equal(2, faults.Count);
        Assert.Contains(faults, fault => fault.Contains("'never'", StringComparison.Ordinal));
        Assert.Contains(faults, fault => fault.Contains("'at once'", StringComparison.Ordinal));
    }

    [Theory, Trait("Clause", "3.1")]
    [InlineData(1, QueueFullMode.Reject)]
    [InlineData(1, QueueFullMode.DropOldest)]
    [InlineData(3, QueueFullMode.Reject)]
    [InlineData(7, QueueFullMode.DropOldest)]
    public void Counters_RandomPushesAndPops_BalanceAndAgreeWithAModel(int capacity, QueueFullMode whenFull)
    {
        const int Seed = 20171;
        var random = new Random(Seed);
        var model = new Queue<int>();
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        QueueReceiver<int> receiver = manager.Receive<int>("queue", capacity, whenFull, wakeOnPush: false);
        QueueSender<int> sender = manager.Send<int>("queue");

        run.StartAndSettle();
        run.On(manager, () =>
        {
            for (int i = 0; i < 5000; i++)
            {
                if (random.Next(5) < 3)
                {
                    Assert.Equal(PushToModel(model, capacity, whenFull, i), sender.Push(i));
                }
                else
                {
                    Assert.Equal(model.Count > 0, receiver.TryPop(out int value));
                    Assert.Equal(model.Count > 0 ? model.Dequeue() : 0, value);
                }

                QueueCounters counters = receiver.Counters;
                Assert.True(
                    counters.Pushed == counters.Popped + counters.Dropped + counters.Resident,
                    $"seed {Seed}, step {i}");
                Assert.Equal(model.Count, receiver.Count);
            }
        });
    }

    [Fact, Trait("Clause", "3.1")]
    public void TryPop_EmptyQueue_IsFalseAndDefault()
    {
        using QueuePair pair = Connect(capacity: 2, QueueFullMode.Reject);
        pair.Run.On(pair.Sink, () =>
        {
            Assert.False(pair.Receiver.TryPop(out int value));
            Assert.Equal(0, value);
        });
    }

    [Fact, Trait("Clause", "3.1"), Trait("Clause", "4.2")]
    public void WaitWhenFull_ManagerSends_IsAWiringFaultThatNamesIt()
    {
        using TestRun run = NewRun();
        run.Add("source").Send<int>("queue");
        run.Add("sink").Receive<int>("queue", 1, QueueFullMode.Wait);
        run.Reactor.Workspace.Send<int>("queue");

        string fault = Assert.Single(Assert.Throws<RabitWiringException>(run.Start).Faults);

        Assert.Contains("'queue'", fault, StringComparison.Ordinal);
        Assert.Contains("'source'", fault, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "2.8")]
    public void End_UsedByAnotherManager_IsAnErrorThatNamesBoth()
    {
        using QueuePair pair = Connect(capacity: 1, QueueFullMode.Reject);
        pair.Run.On(pair.Sink, () => AssertMisuse(() => pair.Sender.Push(1)));
        pair.Run.On(pair.Sink, () => AssertMisuse(() => _ = pair.Sender.Counters));
        pair.Run.On(pair.Source, () => AssertMisuse(() => pair.Receiver.TryPop(out _)));
        pair.Run.On(pair.Source, () => AssertMisuse(() => _ = pair.Receiver.Count));
        pair.Run.On(pair.Source, () => AssertMisuse(() => _ = pair.Receiver.Counters));
    }

    [Fact, Trait("Clause", "2.8"), Trait("Clause", "3.1")]
    public void OutsideSender_AnyThread_MayPush()
    {
        using TestRun run = NewRun();
        ScriptedManager sink = run.Add("sink");
        QueueReceiver<int> receiver = sink.Receive<int>("queue");
        QueueSender<int> outside = run.Reactor.Workspace.Send<int>("queue");

        run.StartAndSettle();
        Assert.Equal(PushResult.Queued, outside.Push(5));
        run.Until(() => sink.Units == 2, "the push wakes the sink");
        run.On(sink, () => Assert.Equal([5], PopAll(receiver)));
    }

    private static void AssertMisuse(Action misuse)
    {
        string text = Assert.Throws<InvalidOperationException>(misuse).Message;
        Assert.Contains("'queue'", text, StringComparison.Ordinal);
        Assert.Contains("'source'", text, StringComparison.Ordinal);
        Assert.Contains("'sink'", text, StringComparison.Ordinal);
    }

    private static void AssertCounters(
        QueueCounters counters, long pushed, long popped, long dropped, long rejected, int resident)
        => Assert.Equal(
            (pushed, popped, dropped, rejected, resident),
            (counters.Pushed, counters.Popped, counters.Dropped, counters.Rejected, counters.Resident));

    private static PushResult[] Push(QueueSender<int> sender, params int[] values)
        => values.Select(v => sender.Push(v)).ToArray();

    private static int[] PopAll(QueueReceiver<int> receiver)
    {
        var values = new List<int>();
        while (receiver.TryPop(out int value))
            values.Add(value);
        return values.ToArray();
    }

    private static PushResult PushToModel(Queue<int> model, int capacity, QueueFullMode whenFull, int value)
    {
        PushResult result = PushResult.Queued;
        if (model.Count == capacity)
        {
            if (whenFull == QueueFullMode.Reject)
                return PushResult.Rejected;
            model.Dequeue();
            result = PushResult.QueuedDroppedOldest;
        }

        model.Enqueue(value);
        return result;
    }

    private QueuePair Connect(int capacity, QueueFullMode whenFull, bool wakeOnPush = false, bool wakeOnPop = false)
        => new(NewRun(), capacity, whenFull, wakeOnPush, wakeOnPop);
}

public sealed class QueueInRealTime() : QueueContract(TimeKind.Real);

public sealed class QueueInVirtualTime() : QueueContract(TimeKind.Virtual);
