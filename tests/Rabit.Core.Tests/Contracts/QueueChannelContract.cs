using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using System.Threading.Channels;
using System.Threading.Tasks;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 3.4: ends of queues that are channels, for async code.</summary>
public abstract class QueueChannelContract(TimeKind kind) : ContractTests(kind)
{
    private static readonly TimeSpan Limit = TimeSpan.FromMilliseconds(30);

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
        while (!feeding.IsCompleted && waited.Elapsed < TestTimeout.Limit)
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

    [Fact, Trait("Clause", "3.4"), Trait("Clause", "3.1")]
    public async Task ChannelWriter_TwoThatWaitForRoom_BothGoOnAtAPop()
    {
        using TestRun run = NewRun();
        ScriptedManager sink = run.Add("sink");
        QueueReceiver<int> receiver = sink.Receive<int>("queue", 1, wakeOnPush: false);
        ChannelWriter<int> writer = run.Reactor.Workspace.Send<int>("queue").AsChannelWriter();
        run.StartAndSettle();
        Assert.True(writer.TryWrite(1));

        Task<bool>[] waiting = [writer.WaitToWriteAsync().AsTask(), writer.WaitToWriteAsync().AsTask()];
        Assert.All(waiting, w => Assert.False(w.IsCompleted));
        run.On(sink, () => Assert.True(receiver.TryPop(out _)));

        Assert.True(await InTime(waiting[0]));
        Assert.True(await InTime(waiting[1]));
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

    [Theory, Trait("Clause", "3.4"), Trait("Clause", "3.5")]
    [InlineData(QueueFullMode.Reject)]
    [InlineData(QueueFullMode.Wait)]
    public async Task ChannelWriter_RunEndsWhileItWaitsForRoom_ComesBackWithout(QueueFullMode mode)
    {
        using TestRun run = NewRun();
        run.Add("sink").Receive<int>("queue", 1, mode, wakeOnPush: false);
        ChannelWriter<int> writer = run.Reactor.Workspace.Send<int>("queue").AsChannelWriter();
        run.StartAndSettle();
        Assert.True(writer.TryWrite(1));
        Task<bool> forRoom = writer.WaitToWriteAsync().AsTask();
        Assert.False(forRoom.IsCompleted);

        run.Finish();

        Assert.False(await InTime(forRoom));
    }

    [Theory, Trait("Clause", "3.4"), Trait("Clause", "3.5")]
    [InlineData(QueueFullMode.Reject)]
    [InlineData(QueueFullMode.Wait)]
    public async Task ChannelReader_NothingIsLeftAtTheEnd_CompletesWithTheRun(QueueFullMode mode)
    {
        using TestRun run = NewRun();
        run.Add("idle");
        ChannelReader<int> reader = run.Reactor.Workspace.Receive<int>("queue", 1, mode).AsChannelReader();
        run.StartAndSettle();
        Assert.False(reader.Completion.IsCompleted);

        run.Finish();

        await InTime(Answer(reader.Completion));
    }

    [Fact, Trait("Clause", "3.4")]
    public async Task ChannelReader_SeveralWaitForTheSameValue_AllAreReleasedByIt()
    {
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        QueueSender<int> sender = source.Send<int>("queue");
        ChannelReader<int> reader = run.Reactor.Workspace.Receive<int>("queue", 10).AsChannelReader();
        run.StartAndSettle();

        Task<bool>[] waits = Enumerable.Range(0, 3).Select(_ => reader.WaitToReadAsync().AsTask()).ToArray();
        Assert.DoesNotContain(waits, w => w.IsCompleted);
        run.On(source, () => sender.Push(1));

        foreach (Task<bool> wait in waits)
            Assert.True(await InTime(wait));
        Assert.True(reader.TryRead(out int value));
        Assert.Equal(1, value);
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
        Assert.True(reader.CanCount);
        Assert.Equal(1, reader.Count);
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

    private static async Task<bool> Answer(Task task)
    {
        await task.ConfigureAwait(false);
        return true;
    }
}

public sealed class QueueChannelInRealTime() : QueueChannelContract(TimeKind.Real);

public sealed class QueueChannelInVirtualTime() : QueueChannelContract(TimeKind.Virtual);
