using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 2.5: buffers that travel by queue come back, whatever becomes of the queue.</summary>
public abstract class BufferContract(TimeKind kind) : ContractTests(kind)
{
    [Fact, Trait("Clause", "2.5"), Trait("Clause", "3.1")]
    public void Queue_BufferFromOneManagerToAnother_HasOneOwnerAtATime()
    {
        var pool = new BufferPool("pictures", 1, 8);
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        ScriptedManager sink = run.Add("sink");
        QueueSender<Picture> sender = source.Send<Picture>("queue");
        QueueReceiver<Picture> receiver = sink.Receive<Picture>("queue", 2, wakeOnPush: false);
        BufferLease kept = default;

        run.StartAndSettle();
        for (int i = 0; i < 20; i++)
        {
            run.On(source, () =>
            {
                Assert.True(pool.TryRent("source", out kept));
                kept.Span[0] = (byte)i;
                Assert.Equal(PushResult.Queued, sender.Push(new Picture { Number = i, Pixels = kept }));
            });
            run.On(sink, () =>
            {
                Assert.True(receiver.TryPop(out Picture picture));
                BufferLease mine = picture.Pixels.HandTo("sink");
                Assert.Equal(i, mine.Span[0]);
                Assert.Contains(
                    "'sink' has it now", Assert.Throws<InvalidOperationException>(() => _ = kept.Array).Message,
                    StringComparison.Ordinal);
                mine.Dispose();
            });
        }

        Assert.Equal(1, pool.Free);
        Assert.Equal(0, run.Finish().ExitCode);
    }

    [Fact, Trait("Clause", "2.5"), Trait("Clause", "3.1")]
    public void PushFrom_MoreBuffersThanFit_QueuesTheFirstAndTheRestStayTheSenders()
    {
        var pool = new BufferPool("pictures", 5, 8);
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        QueueSender<Picture> sender = source.Send<Picture>("queue");
        QueueReceiver<Picture> receiver = run.Add("sink").Receive<Picture>("queue", 2, wakeOnPush: false);

        run.StartAndSettle();
        run.On(source, () =>
        {
            Picture[] pictures = [.. Enumerable.Range(0, 5).Select(i => Take(pool, i))];
            Assert.Equal(2, sender.PushFrom(pictures));
            Assert.Equal((2L, 3L), (sender.Counters.Pushed, sender.Counters.Rejected));
            foreach (Picture picture in pictures.Skip(2))
                picture.Pixels.Dispose();
            Assert.Equal(3, pool.Free);
        });
        run.Finish();

        Assert.Equal(("queue", 5), (receiver.Name, pool.Free));
    }

    [Fact, Trait("Clause", "2.5"), Trait("Clause", "3.1")]
    public void Queue_DropsTheOldest_GivesItsBufferBack()
    {
        var pool = new BufferPool("pictures", 3, 8);
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        ScriptedManager sink = run.Add("sink");
        QueueSender<Picture> sender = source.Send<Picture>("queue");
        QueueReceiver<Picture> receiver = sink.Receive<Picture>(
            "queue", 2, QueueFullMode.DropOldest, wakeOnPush: false);

        run.StartAndSettle();
        run.On(source, () =>
        {
            for (int i = 0; i < 10; i++)
                Assert.Equal(i < 2 ? PushResult.Queued : PushResult.QueuedDroppedOldest, sender.Push(Take(pool, i)));
            QueueCounters counters = sender.Counters;
            Assert.Equal((10, 8, 2), (counters.Pushed, counters.Dropped, counters.Resident));
        });
        Assert.Equal(1, pool.Free);
        run.On(sink, () =>
        {
            for (int i = 8; i < 10; i++)
            {
                Assert.True(receiver.TryPop(out Picture picture));
                Assert.Equal(i, picture.Number);
                picture.Dispose();
            }
        });
        Assert.Equal(3, pool.Free);
    }

    [Fact, Trait("Clause", "2.5"), Trait("Clause", "3.1")]
    public void Queue_RejectsAPush_TheBufferStaysTheSenders()
    {
        var pool = new BufferPool("pictures", 2, 8);
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        QueueSender<Picture> sender = source.Send<Picture>("queue");
        run.Add("sink").Receive<Picture>("queue", 1, QueueFullMode.Reject, wakeOnPush: false);

        run.StartAndSettle();
        run.On(source, () =>
        {
            sender.Push(Take(pool, 0));
            Picture refused = Take(pool, 1);
            Assert.Equal(PushResult.Rejected, sender.Push(refused));
            Assert.Equal(8, refused.Pixels.Span.Length);
            refused.Dispose();
            Assert.Equal(1, pool.Free);
        });
    }

    [Fact, Trait("Clause", "2.5"), Trait("Clause", "5.1")]
    public void Finish_BuffersStillInAQueue_GivesThemBack()
    {
        var pool = new BufferPool("pictures", 3, 8);
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        QueueSender<Picture> sender = source.Send<Picture>("queue");
        QueueSender<Picture> outside = run.Reactor.Workspace.Send<Picture>("queue");
        run.Add("sink").Receive<Picture>("queue", 8, wakeOnPush: false);
        source.OnShutdown = () => sender.Push(Take(pool, 2));

        run.StartAndSettle();
        run.On(source, () => sender.Push(Take(pool, 0)));
        outside.Push(Take(pool, 1));
        Assert.Equal(1, pool.Free);
        run.Finish();

        Assert.Equal(3, pool.Free);
        QueueCounters counters = outside.Counters;
        Assert.Equal((3, 3, 0), (counters.Pushed, counters.Dropped, counters.Resident));
        Assert.Equal(PushResult.Rejected, outside.Push(default));
        Assert.Equal(0, outside.Counters.Resident);
    }

    [Fact, Trait("Clause", "2.5")]
    public void Finish_BufferOfAWatchedPoolNotGivenBack_IsAnErrorThatNamesPoolAndOwner()
    {
        var pool = new BufferPool("pictures", 3, 8);
        var microphone = new BufferPool("sounds", 1, 8);
        using TestRun run = NewRun();
        ScriptedManager keeper = run.Add("keeper");
        ScriptedManager other = run.Add("other");
        run.Reactor.Workspace.Watch(pool);
        run.Reactor.Workspace.Watch(microphone);
        run.Reactor.Workspace.Watch(pool);

        run.StartAndSettle();
        run.On(keeper, () =>
        {
            Assert.True(pool.TryRent("keeper", out _));
            Assert.True(pool.TryRent("keeper", out _));
            Assert.True(microphone.TryRent("keeper", out BufferLease lease));
            lease.Dispose();
        });
        run.On(other, () => Assert.True(pool.TryRent("other", out _)));
        ReactorResult result = run.Finish();

        const string Expected =
            "Pool 'pictures' did not get all of its buffers back: 'keeper' has 2; 'other' has 1.";
        Assert.Equal(1, result.ExitCode);
        Assert.Equal(Expected, result.Failure!.Message);
        Assert.Equal("the test is over", result.StopReason);
        Assert.Equal(Expected, Assert.Single(run.Log, e => e.Kind == RabitLogKind.Fault).Text);
    }

    [Fact, Trait("Clause", "2.5"), Trait("Clause", "3.1")]
    public void Finish_BuffersOfAWatchedPoolInAQueueAndInShutdown_AreNoLeak()
    {
        var pool = new BufferPool("pictures", 2, 8);
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        QueueSender<Picture> sender = source.Send<Picture>("queue");
        run.Add("sink").Receive<Picture>("queue", 8, wakeOnPush: false);
        BufferLease kept = default;
        source.OnShutdown = () => kept.Dispose();

        run.StartAndSettle();
        run.On(source, () =>
        {
            sender.Push(Take(pool, 0));
            Assert.True(pool.TryRent("source", out kept));
            run.Reactor.Workspace.Watch(pool);
        });

        Assert.Equal(0, run.Finish().ExitCode);
        Assert.Equal(2, pool.Free);
    }

    [Fact, Trait("Clause", "2.5"), Trait("Clause", "1.8")]
    public void Reader_QueueFull_GivesBackWhatItDiscards()
    {
        foreach (QueueFullMode whenFull in new[] { QueueFullMode.Wait, QueueFullMode.Reject, QueueFullMode.DropOldest })
        {
            var source = new PictureSource(new BufferPool("pictures", 4, 8));
            using TestRun run = NewRun();
            ScriptedManager manager = run.Add("m");
            BlockingReader<Picture> reader = manager.AttachReader("camera", source, capacity: 2, whenFull);

            run.StartAndSettle();
            int leftAtTheEnd = whenFull == QueueFullMode.Wait ? 7 : 0;
            run.Until(() => source.Left == leftAtTheEnd, "it reads until the queue stops it, or all");
            run.Finish();

            Assert.Equal("Pool 'pictures': 4 of 4 buffers are free, 0 times none was.", source.Pool.Describe());
            Assert.Equal(whenFull == QueueFullMode.Wait ? 1 : 0, reader.Discarded);
        }
    }

    [Fact, Trait("Clause", "2.5"), Trait("Clause", "3.1")]
    public void Queue_ValueThatThrowsWhenDisposed_IsReportedAndTheQueueGoesOn()
    {
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        ScriptedManager sink = run.Add("sink");
        QueueSender<Grenade> sender = source.Send<Grenade>("queue");
        QueueReceiver<Grenade> receiver = sink.Receive<Grenade>(
            "queue", 1, QueueFullMode.DropOldest, wakeOnPush: false);

        run.StartAndSettle();
        run.On(source, () =>
        {
            sender.Push(new Grenade(1));
            Assert.Equal(PushResult.QueuedDroppedOldest, sender.Push(new Grenade(2)));
        });
        run.On(sink, () =>
        {
            Assert.True(receiver.TryPop(out Grenade? value));
            Assert.Equal(2, value!.Number);
        });
        run.On(source, () => sender.Push(new Grenade(3)));
        Assert.Equal(0, run.Finish().ExitCode);

        IEnumerable<RabitLogEntry> faults = run.Log.Where(e => e.Kind == RabitLogKind.Fault);
        Assert.Equal(["bang 1", "bang 3"], faults.Select(e => e.Exception!.Message));
        Assert.All(faults, e => Assert.Equal("queue", e.Source));
    }

    [Fact, Trait("Clause", "2.5"), Trait("Clause", "3.1")]
    public void Queue_ThatDropsTheNewest_DisposesThatOne()
    {
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        QueueSender<Grenade> sender = source.Send<Grenade>("queue");
        run.Add("sink").Receive<Grenade>("queue", 2, QueueFullMode.DropNewest, wakeOnPush: false);

        run.StartAndSettle();
        run.On(source, () =>
        {
            sender.Push(new Grenade(1));
            sender.Push(new Grenade(2));
            Assert.Equal(PushResult.QueuedDroppedNewest, sender.Push(new Grenade(3)));
        });

        Assert.Equal("bang 2", Assert.Single(run.Log, e => e.Kind == RabitLogKind.Fault).Exception!.Message);
    }

    // What it disposes is user code, which may wait for another thread that looks into the workspace.
    [Fact]
    public void Finish_DisposesWhatIsLeft_UnderNoLockOfTheWorkspace()
    {
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        QueueSender<Asker> sender = source.Send<Asker>("queue");
        run.Add("sink").Receive<Asker>("queue", 1, wakeOnPush: false);
        var value = new Asker(run.Reactor.Workspace);

        run.StartAndSettle();
        run.On(source, () => sender.Push(value));
        run.Finish();

        Assert.True(value.WasAnswered);
    }

    private static Picture Take(BufferPool pool, int number)
    {
        Assert.True(pool.TryRent("source", out BufferLease lease));
        return new Picture { Number = number, Pixels = lease };
    }

    private struct Picture : IDisposable
    {
        public int Number;
        public BufferLease Pixels;

        public readonly void Dispose() => Pixels.Dispose();
    }

    private sealed class Grenade(int number) : IDisposable
    {
        public int Number { get; } = number;

        public void Dispose() => throw new InvalidOperationException("bang " + Number);
    }

    /// <summary>Disposed, it has another thread ask the workspace, and waits for the answer.</summary>
    private sealed class Asker(RabitWorkspace workspace) : IDisposable
    {
        public bool WasAnswered { get; private set; }

        public void Dispose()
        {
            var other = new Thread(() => workspace.DescribeWiring()) { IsBackground = true };
            other.Start();
            WasAnswered = other.Join(TestTimeout.Limit);
        }
    }

    /// <summary>Ten pictures as fast as they are taken, then waits for ever.</summary>
    private sealed class PictureSource(BufferPool pool) : IReaderSource<Picture>
    {
        public BufferPool Pool { get; } = pool;

        public int Left { get; private set; } = 10;

        public bool Blocks => false;

        public void Open(ReaderContext context)
        {
        }

        public ReaderStep Read(out Picture value)
        {
            value = default;
            if (Left == 0 || !Pool.TryRent("camera", out value.Pixels))
                return ReaderStep.WaitForSignal;
            value.Number = 10 - Left--;
            return ReaderStep.Value;
        }

        public void Unblock()
        {
        }

        public void Close()
        {
        }
    }
}

public sealed class BuffersInRealTime() : BufferContract(TimeKind.Real);

public sealed class BuffersInVirtualTime() : BufferContract(TimeKind.Virtual);
