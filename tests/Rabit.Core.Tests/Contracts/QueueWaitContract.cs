using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using System.Threading.Channels;
using System.Threading.Tasks;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 3.1 and 3.4: readers and async code that wait for a queue, and ends that are channels.</summary>
public abstract class QueueWaitContract(TimeKind kind) : ContractTests(kind)
{
    // Only a test that fails waits this long.
    private static TimeSpan MaxWait => TestTimeout.Limit;
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

    [Fact, Trait("Clause", "3.4"), Trait("Clause", "3.1")]
    public async Task ChannelWriter_FullQueue_WaitsAndLosesNothing()
    {
        const int Values = 50;
        using TestRun run = NewRun();
        ScriptedManager sink = run.Add("sink");
        QueueReceiver<int> receiver = sink.Receive<int>("queue", 3);
        ChannelWriter<int> writer = run.Reactor.Workspace.Send<int>("queue").AsChannelWriter();
        var got = new List<int>();
        sink.OnUnit = () =>
        {
            while (receiver.TryPop(out int value))
                got.Add(value);
        };
        run.StartAndSettle();

        Task feeding = Feed();
        var waited = Stopwatch.StartNew();
        while (!feeding.IsCompleted && waited.Elapsed < MaxWait)
            run.Reactor.RunFor(TimeSpan.FromMilliseconds(1));
        Assert.True(feeding.IsCompleted);
        await feeding;
        run.OnAndSettle(sink, () => { });
        run.OnAndSettle(sink, () => { });

        Assert.Equal(Enumerable.Range(0, Values), got);
        Assert.Equal(0, run.Finish().Queues.Single(q => q.Name == "queue").Counters.Rejected);
        Assert.False(writer.TryWrite(1));
        Assert.False(await InTime(writer.WaitToWriteAsync().AsTask()));
        var closed = await Assert.ThrowsAsync<ChannelClosedException>(() => writer.WriteAsync(1).AsTask());
        Assert.Contains("'queue'", closed.Message, StringComparison.Ordinal);

        async Task Feed()
        {
            for (int i = 0; i < Values; i += 2)
            {
                await writer.WriteAsync(i).ConfigureAwait(false);
                while (await writer.WaitToWriteAsync().ConfigureAwait(false) && !writer.TryWrite(i + 1))
                {
                    // Another receiver was faster; here there is none.
                    run.Board.Write("refused");
                }
            }
        }
    }

    [Fact, Trait("Clause", "3.4")]
    public async Task ChannelWriter_QueueWithATimeLimit_ThrowsWhenItIsUp()
    {
        using TestRun run = NewRun();
        run.Add("sink").Receive<int>("queue", 1, QueueFullMode.Wait, wakeOnPush: false, maxWait: Limit);
        ChannelWriter<int> writer = run.Reactor.Workspace.Send<int>("queue").AsChannelWriter();
        run.StartAndSettle();

        Assert.True(writer.TryWrite(1));
        Assert.False(writer.TryWrite(2));
        TimeSpan begin = run.Reactor.Now;
        Task late = writer.WriteAsync(3).AsTask();
        run.Until(() => run.Reactor.Now >= begin + Limit, "the time is up");

        string text = (await Assert.ThrowsAsync<TimeoutException>(() => InTime(Answer(late)))).Message;
        Assert.Contains("'queue'", text, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "3.4"), Trait("Clause", "3.5")]
    public async Task ChannelReader_DrainsWhatAManagerPushes_AndCompletesWithTheRun()
    {
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        QueueSender<int> sender = source.Send<int>("queue");
        ChannelReader<int> reader = run.Reactor.Workspace.Receive<int>("queue", 10).AsChannelReader();
        run.StartAndSettle();

        Task<List<int>> draining = Drain();
        run.On(source, () => Assert.Equal(PushResult.Queued, sender.Push(1)));
        run.On(source, () => Assert.Equal(2, sender.PushFrom([2, 3])));
        run.Finish();

        Assert.Equal([1, 2, 3], await InTime(draining));
        await InTime(Answer(reader.Completion));
        Assert.False(await reader.WaitToReadAsync());

        async Task<List<int>> Drain()
        {
            var got = new List<int>();
            while (await reader.WaitToReadAsync().ConfigureAwait(false))
            {
                while (reader.TryRead(out int value))
                    got.Add(value);
            }

            return got;
        }
    }

    [Fact, Trait("Clause", "3.4"), Trait("Clause", "3.5")]
    public async Task ChannelReader_ValuesLeftAtTheEnd_CanStillBeReadAndAreReported()
    {
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        QueueSender<string> sender = source.Send<string>("queue");
        ChannelReader<string> reader = run.Reactor.Workspace.Receive<string>("queue", 10).AsChannelReader();
        run.StartAndSettle();

        run.On(source, () => sender.PushFrom(["a", "b"]));
        QueueResult result = run.Finish().Queues.Single(q => q.Name == "queue");

        Assert.Equal(2, result.Counters.Resident);
        Assert.Equal(2, reader.Count);
        Assert.True(reader.TryRead(out string? first));
        Assert.Equal("a", first);
        Assert.False(reader.Completion.IsCompleted);
        Assert.True(await reader.WaitToReadAsync());
        Assert.True(reader.TryRead(out _));
        await InTime(Answer(reader.Completion));
    }

    [Fact, Trait("Clause", "3.4")]
    public async Task Channel_WaitCancelled_IsCancelledAndTheQueueGoesOn()
    {
        using TestRun run = NewRun();
        ScriptedManager idle = run.Add("idle");
        ChannelWriter<int> writer = run.Reactor.Workspace.Send<int>("queue").AsChannelWriter();
        ChannelReader<int> reader = run.Reactor.Workspace.Receive<int>("queue", 1).AsChannelReader();
        using var cancellation = new CancellationTokenSource();
        run.StartAndSettle();

        Task<bool> forNews = reader.WaitToReadAsync(cancellation.Token).AsTask();
        Assert.True(writer.TryWrite(1));
        Assert.True(await InTime(forNews));
        Task<bool> forRoom = writer.WaitToWriteAsync(cancellation.Token).AsTask();
        cancellation.Cancel();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => InTime(forRoom));
        Assert.True(reader.TryRead(out _));
        await Assert.ThrowsAnyAsync<OperationCanceledException>(
            () => reader.WaitToReadAsync(cancellation.Token).AsTask());

        Assert.True(writer.TryWrite(2));
        Assert.True(await reader.WaitToReadAsync());
        Assert.Equal(1, idle.Units);
    }

    [Fact, Trait("Clause", "3.4"), Trait("Clause", "4.2")]
    public void AsChannel_AfterTheStart_IsRefused()
    {
        using TestRun run = NewRun();
        run.Add("sink").Receive<int>("queue");
        QueueSender<int> outside = run.Reactor.Workspace.Send<int>("queue");
        run.Start();

        Assert.Contains(
            "'queue'", Assert.Throws<InvalidOperationException>(() => outside.AsChannelWriter()).Message,
            StringComparison.Ordinal);
    }

    private static void AssertCounters(
        QueueCounters counters, long pushed, long popped, long rejected, int resident, int highWater)
        => Assert.Equal(
            (pushed, popped, 0, rejected, resident, highWater),
            (counters.Pushed, counters.Popped, counters.Dropped, counters.Rejected, counters.Resident,
                counters.HighWater));

    private static int Pop(QueueReceiver<int> receiver) => receiver.TryPop(out int value) ? value : -1;

    private static async Task<bool> Answer(Task task)
    {
        await task.ConfigureAwait(false);
        return true;
    }

    private static async Task<TResult> InTime<TResult>(Task<TResult> task)
    {
        Assert.Same(task, await Task.WhenAny(task, Task.Delay(MaxWait)).ConfigureAwait(false));
        return await task.ConfigureAwait(false);
    }

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
