using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 3.1: readers and async code that wait for a queue.</summary>
public abstract class QueueWaitContract(TimeKind kind) : ContractTests(kind)
{
    private static readonly TimeSpan Limit = TimeSpan.FromMilliseconds(30);

    [Fact, Trait("Clause", "3.1")]
    public async Task PushAsync_QueueIsFull_WaitsForAPopAndKeepsTheOrder()
    {
        using TestRun run = NewRun();
        ScriptedManager sink = run.Add("sink");
        QueueReceiver<int> receiver = sink.Receive<int>("queue", 2, QueueFullMode.Wait, wakeOnPush: false);
        QueueSender<int> outside = run.Reactor.Workspace.Send<int>("queue");
        run.StartAndSettle();

        Task<PushResult>[] pushes = Enumerable.Range(1, 5).Select(i => outside.PushAsync(i).AsTask()).ToArray();
        Assert.Equal([true, true, false, false, false], pushes.Select(p => p.IsCompleted));
        for (int i = 1; i <= 5; i++)
        {
            run.On(sink, () =>
            {
                Assert.True(receiver.TryPop(out int value));
                Assert.Equal(i, value);
            });
            Assert.Equal(PushResult.Queued, await InTime(pushes[i - 1]));
        }

        AssertCounters(outside.Counters, pushed: 5, popped: 5, rejected: 0, resident: 0, highWater: 2);
    }

    [Fact, Trait("Clause", "3.1"), Trait("Clause", "1.4")]
    public async Task PushAsync_QueueHasRoom_WakesTheReceiver()
    {
        using TestRun run = NewRun();
        ScriptedManager sink = run.Add("sink");
        sink.Receive<int>("queue", 2, QueueFullMode.Wait);
        QueueSender<int> outside = run.Reactor.Workspace.Send<int>("queue");
        run.StartAndSettle();

        Assert.Equal(PushResult.Queued, await InTime(outside.PushAsync(1).AsTask()));

        run.Until(() => sink.Units >= 2, "the push wakes the sink");
        Assert.Equal(WakeUpCauses.Push, sink.Causes[1]);
    }

    [Fact, Trait("Clause", "3.1")]
    public async Task PushAsync_NoRoomForAsLongAsItMayWait_TimesOutAndIsCounted()
    {
        using TestRun run = NewRun();
        ScriptedManager sink = run.Add("sink");
        QueueReceiver<int> receiver = sink.Receive<int>(
            "queue", 1, QueueFullMode.Wait, wakeOnPush: false, maxWait: Limit);
        QueueSender<int> outside = run.Reactor.Workspace.Send<int>("queue");
        run.StartAndSettle();

        Assert.Equal(PushResult.Queued, await outside.PushAsync(1));
        TimeSpan begin = run.Reactor.Now;
        Task<PushResult> late = outside.PushAsync(2).AsTask();
        run.Until(() => run.Reactor.Now >= begin + Limit, "the time is up");

        Assert.Equal(PushResult.TimedOut, await InTime(late));
        AssertCounters(outside.Counters, pushed: 1, popped: 0, rejected: 1, resident: 1, highWater: 1);
        run.On(sink, () => Assert.True(receiver.TryPop(out _)));
        Assert.Equal(PushResult.Queued, await InTime(outside.PushAsync(3).AsTask()));
    }

    /// <summary>The pop makes room for the value that waits, and that is news to the receiver.</summary>
    [Fact, Trait("Clause", "3.1"), Trait("Clause", "1.4")]
    public async Task PushAsync_GetsItsRoomByAPop_WakesTheReceiverThatTakesOneAtATime()
    {
        using TestRun run = NewRun();
        ScriptedManager sink = run.Add("sink");
        QueueReceiver<int> receiver = sink.Receive<int>("queue", 1, QueueFullMode.Wait);
        var got = new List<int>();
        sink.OnUnit = () =>
        {
            if (receiver.TryPop(out int value))
                got.Add(value);
        };
        QueueSender<int> outside = run.Reactor.Workspace.Send<int>("queue");
        run.StartAndSettle();

        Task<PushResult>[] pushes = [.. Enumerable.Range(1, 4).Select(i => outside.PushAsync(i).AsTask())];
        run.Until(() => outside.Counters.Popped == 4, "the sink takes out all");

        foreach (Task<PushResult> push in pushes)
            Assert.Equal(PushResult.Queued, await InTime(push));
        run.Finish();
        Assert.Equal([1, 2, 3, 4], got);
    }

    [Fact, Trait("Clause", "3.1")]
    public async Task PushAsync_QueuesWhoseSendersMayWaitDifferentlyLong_EachTimesOutByItsOwn()
    {
        using TestRun run = NewRun();
        ScriptedManager sink = run.Add("sink");
        TimeSpan[] limits = [TimeSpan.FromHours(2), Limit, TimeSpan.FromHours(3)];
        var waiting = new Task<PushResult>[limits.Length];
        QueueSender<int>[] outside = [.. limits.Select((limit, i) =>
        {
            sink.Receive<int>($"queue {i}", 1, QueueFullMode.Wait, wakeOnPush: false, maxWait: limit);
            return run.Reactor.Workspace.Send<int>($"queue {i}");
        })];
        run.StartAndSettle();
        for (int i = 0; i < limits.Length; i++)
        {
            await outside[i].PushAsync(1);
            waiting[i] = outside[i].PushAsync(2).AsTask();
        }

        run.Until(() => waiting[1].IsCompleted, "its time is up");

        Assert.Equal(PushResult.TimedOut, await waiting[1]);
        Assert.False(waiting[0].IsCompleted || waiting[2].IsCompleted);
        run.Finish();
        Assert.Equal(PushResult.Rejected, await InTime(waiting[2]));
    }

    [Fact, Trait("Clause", "3.1")]
    public async Task PushAsync_OneTimesOut_TheLaterOneStillWaits()
    {
        using TestRun run = NewRun();
        run.Add("ticker").WakeUpDelay = TimeSpan.FromMilliseconds(1);
        run.Add("sink").Receive<int>("queue", 1, QueueFullMode.Wait, wakeOnPush: false, maxWait: Limit);
        QueueSender<int> outside = run.Reactor.Workspace.Send<int>("queue");
        run.StartAndSettle();
        await outside.PushAsync(1);
        TimeSpan begin = run.Reactor.Now;
        Task<PushResult> first = outside.PushAsync(2).AsTask();
        run.Until(() => run.Reactor.Now >= begin + TimeSpan.FromTicks(Limit.Ticks / 2), "half of the time is over");
        bool wasEarly = first.IsCompleted && run.Reactor.Now < begin + Limit;
        TimeSpan middle = run.Reactor.Now;
        Task<PushResult> second = outside.PushAsync(3).AsTask();
        run.Until(() => first.IsCompleted, "the first one's time is up");
        wasEarly |= second.IsCompleted && run.Reactor.Now < middle + Limit;
        run.Until(() => second.IsCompleted, "the second one's time is up");

        Assert.False(wasEarly);
        Assert.Equal(PushResult.TimedOut, await first);
        Assert.Equal(PushResult.TimedOut, await second);
    }

    [Fact, Trait("Clause", "3.1")]
    public async Task PushAsync_Cancelled_IsNotPutInAndLetsTheNextOneGo()
    {
        using TestRun run = NewRun();
        ScriptedManager sink = run.Add("sink");
        QueueReceiver<int> receiver = sink.Receive<int>("queue", 1, QueueFullMode.Wait, wakeOnPush: false);
        QueueSender<int> outside = run.Reactor.Workspace.Send<int>("queue");
        using var cancellation = new CancellationTokenSource();
        run.StartAndSettle();

        await outside.PushAsync(1);
        Task<PushResult> second = outside.PushAsync(2, cancellation.Token).AsTask();
        Task<PushResult> third = outside.PushAsync(3).AsTask();
        cancellation.Cancel();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => InTime(second));
        run.On(sink, () => Assert.Equal(1, Pop(receiver)));

        Assert.Equal(PushResult.Queued, await InTime(third));
        run.On(sink, () => Assert.Equal(3, Pop(receiver)));
        await Assert.ThrowsAnyAsync<OperationCanceledException>(
            () => outside.PushAsync(4, cancellation.Token).AsTask());
    }

    [Fact, Trait("Clause", "3.1")]
    public async Task PushAsync_CancelledManyTimesWhileTheQueueIsFull_KeepsNothing()
    {
        using TestRun run = NewRun();
        run.Add("sink").Receive<byte[]>("queue", 1, QueueFullMode.Wait, wakeOnPush: false);
        QueueSender<byte[]> outside = run.Reactor.Workspace.Send<byte[]>("queue");
        run.StartAndSettle();

        await outside.PushAsync([]);
        var values = new List<WeakReference>();
        for (int i = 0; i < 100; i++)
            values.Add(await PushInVain(outside));
        GC.Collect();

        // The last ones may still be on a stack.
        Assert.InRange(values.Count(v => v.IsAlive), 0, 10);
    }

    [Fact, Trait("Clause", "3.1")]
    public async Task PushAsync_TimedOutManyTimesWhileNothingIsPopped_KeepsNothing()
    {
        using TestRun run = NewRun();
        TimeSpan limit = TimeSpan.FromMilliseconds(1);
        run.Add("sink").Receive<byte[]>("queue", 1, QueueFullMode.Wait, wakeOnPush: false, maxWait: limit);
        QueueSender<byte[]> outside = run.Reactor.Workspace.Send<byte[]>("queue");
        run.StartAndSettle();

        await outside.PushAsync([]);
        var values = new List<WeakReference>();
        for (int i = 0; i < 40; i++)
        {
            TimeSpan begin = run.Reactor.Now;
            (WeakReference value, Task<PushResult> push) = Push(outside, CancellationToken.None);
            values.Add(value);
            run.Until(() => run.Reactor.Now >= begin + limit, "the time is up");
            Assert.Equal(PushResult.TimedOut, await InTime(push));
        }

        GC.Collect();

        // The last ones may still be on a stack.
        Assert.InRange(values.Count(v => v.IsAlive), 0, 10);
    }

    [Fact, Trait("Clause", "3.1"), Trait("Clause", "3.5")]
    public async Task PushAsync_RunEndsMeanwhile_IsRejected()
    {
        using TestRun run = NewRun();
        run.Add("sink").Receive<int>("queue", 1, QueueFullMode.Wait, wakeOnPush: false);
        QueueSender<int> outside = run.Reactor.Workspace.Send<int>("queue");
        run.StartAndSettle();

        await outside.PushAsync(1);
        Task<PushResult> waiting = outside.PushAsync(2).AsTask();
        run.Finish();

        Assert.Equal(PushResult.Rejected, await InTime(waiting));
        Assert.Equal(PushResult.Rejected, await InTime(outside.PushAsync(3).AsTask()));
    }

    [Fact, Trait("Clause", "3.1")]
    public async Task Push_WithoutWaitingIntoAQueueThatMakesItsSendersWait_IsAnErrorThatSaysHow()
    {
        using TestRun run = NewRun();
        run.Add("sink").Receive<int>("queue", 1, QueueFullMode.Wait);
        QueueSender<int> outside = run.Reactor.Workspace.Send<int>("queue");
        run.StartAndSettle();

        Assert.Contains(
            "PushAsync", Assert.Throws<InvalidOperationException>(() => outside.Push(1)).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "'queue'", Assert.Throws<InvalidOperationException>(() => outside.PushFrom([1])).Message,
            StringComparison.Ordinal);
        Assert.Equal(PushResult.Queued, await outside.PushAsync(1));
    }

    [Fact, Trait("Clause", "3.1"), Trait("Clause", "2.8")]
    public void AsyncUse_OfAManagersEnd_IsAnErrorThatNamesIt()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        QueueReceiver<int> receiver = manager.Receive<int>("queue");
        QueueSender<int> sender = manager.Send<int>("queue");

        Assert.Contains(
            "'m'", Assert.Throws<InvalidOperationException>(() => sender.AsChannelWriter()).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "'m'", Assert.Throws<InvalidOperationException>(() => receiver.AsChannelReader()).Message,
            StringComparison.Ordinal);
        run.StartAndSettle();
        run.On(manager, () =>
            Assert.Contains(
                "'m'", Assert.Throws<InvalidOperationException>(() => sender.PushAsync(1).AsTask().Status).Message,
                StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "3.1")]
    public void Reader_NoRoomForAsLongAsItMayWait_RejectsAndReadsOn()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var source = new ScriptedSource(run.Board, TimeSpan.Zero, 1, 2, 3);
        BlockingReader<int> reader = manager.AttachReader(
            "line", source, capacity: 1, QueueFullMode.Wait, maxWait: Limit);
        TimeSpan begin = run.Reactor.Now;

        run.Start();
        run.Until(() => reader.State == DeviceState.Ended, "the reader ends");
        TimeSpan end = run.Reactor.Now;

        run.On(manager, () =>
        {
            Assert.True(reader.TryPop(out int value));
            Assert.Equal(1, value);
            AssertCounters(reader.Counters, pushed: 1, popped: 1, rejected: 2, resident: 0, highWater: 1);
        });
        Assert.True(end - begin >= Limit + Limit);
        if (!Kind.HasThreads)
            Assert.True(end - begin <= Limit + Limit + TimeSpan.FromMilliseconds(1));
    }

    private static void AssertCounters(
        QueueCounters counters, long pushed, long popped, long rejected, int resident, int highWater)
        => Assert.Equal(
            (pushed, popped, 0, rejected, resident, highWater),
            (counters.Pushed, counters.Popped, counters.Dropped, counters.Rejected, counters.Resident,
                counters.HighWater));

    private static int Pop(QueueReceiver<int> receiver) => receiver.TryPop(out int value) ? value : -1;

    private static async Task<WeakReference> PushInVain(QueueSender<byte[]> sender)
    {
        using var cancellation = new CancellationTokenSource();
        (WeakReference value, Task<PushResult> push) = Push(sender, cancellation.Token);
        cancellation.Cancel();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => InTime(push));
        return value;
    }

    private static (WeakReference Value, Task<PushResult> Push) Push(
        QueueSender<byte[]> sender, CancellationToken cancellation)
    {
        var value = new byte[1000];
        return (new WeakReference(value), sender.PushAsync(value, cancellation).AsTask());
    }
}

public sealed class QueueWaitInRealTime() : QueueWaitContract(TimeKind.Real);

public sealed class QueueWaitInVirtualTime() : QueueWaitContract(TimeKind.Virtual);
