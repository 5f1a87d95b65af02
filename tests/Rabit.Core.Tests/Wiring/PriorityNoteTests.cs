using System;
using System.Linq;
using Rabit.Core.Diagnostics;
using Rabit.Core.Locks;
using Rabit.Core.Queues;
using Rabit.Core.Tests.Contracts;
using Rabit.Core.Tests.Time;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;
using Xunit;

namespace Rabit.Core.Tests.Wiring;

/// <summary>
/// Contract 1.8: the lock of a queue that a manager of a real-time priority uses, and the note on it.
/// </summary>
public sealed class PriorityNoteTests
{
    [Theory, Trait("Clause", "1.8"), Trait("Clause", "4.2")]
    [InlineData(QueueFullMode.DropOldest, 50, true)]
    [InlineData(QueueFullMode.DropNewest, 50, true)]
    [InlineData(QueueFullMode.Reject, 50, false)]   // no lock
    [InlineData(QueueFullMode.DropOldest, null, false)]
    public void Notes_ManagerWithAPriority_SayWhichLockedQueueItUses(
        QueueFullMode whenFull, int? priority, bool isNoted)
    {
        using var run = new TestRun(TimeKind.Virtual);
        run.Reactor.Add(new Asking("sender", priority, m => m.Send<int>("orders")));
        ScriptedManager receiver = run.Add("receiver");
        receiver.Receive<int>("orders", capacity: 8, whenFull);

        run.Start();
        run.Finish();

        string[] notes = NotesOfLocks(run);
        Assert.Equal(isNoted ? 1 : 0, notes.Length);
        if (isNoted)
            Assert.StartsWith(
                "manager 'sender' of a real-time priority may wait for the lock of queue 'orders', for as long as ",
                notes[0], StringComparison.Ordinal);
    }

    [Theory, Trait("Clause", "1.8"), Trait("Clause", "4.2")]
    [InlineData(QueueFullMode.DropOldest, 50, true)]
    [InlineData(QueueFullMode.DropNewest, 50, true)]
    [InlineData(QueueFullMode.Reject, 50, false)]   // no lock
    [InlineData(QueueFullMode.DropOldest, null, false)]
    public void Notes_ReceiverWithAPriority_SayWhichLockedQueueItUses(
        QueueFullMode whenFull, int? priority, bool isNoted)
    {
        using var run = new TestRun(TimeKind.Virtual);
        run.Reactor.Add(new Asking("receiver", priority, m => m.Receive<int>("orders", capacity: 8, whenFull)));
        run.Add("sender").Send<int>("orders");

        AssertNotes(run, isNoted ? [("receiver", "orders")] : []);
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "4.2")]
    public void Notes_BothEndsWithAPriority_NameBoth()
    {
        using var run = new TestRun(TimeKind.Virtual);
        run.Reactor.Add(new Asking("sender", 20, m => m.Send<int>("orders")));
        run.Reactor.Add(
            new Asking("receiver", 50, m => m.Receive<int>("orders", capacity: 8, QueueFullMode.DropOldest)));

        AssertNotes(run, ("sender", "orders"), ("receiver", "orders"));
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "4.2")]
    public void Notes_QueueOfAManagerToItself_HaveNoneSinceNoOtherHoldsItsLock()
    {
        using var run = new TestRun(TimeKind.Virtual);
        run.Reactor.Add(new Asking("m", 50, m =>
        {
            m.Send<int>("orders");
            m.Receive<int>("orders", capacity: 8, QueueFullMode.DropOldest);
        }));

        AssertNotes(run);
    }

    // The reader waits for room by default, which needs a lock, and its thread has no priority.
    [Theory, Trait("Clause", "1.8"), Trait("Clause", "4.2")]
    [InlineData(QueueFullMode.Wait, 50, true)]
    [InlineData(QueueFullMode.DropOldest, 50, true)]
    [InlineData(QueueFullMode.Reject, 50, false)]
    [InlineData(QueueFullMode.Wait, null, false)]
    public void Notes_ReaderOfAManagerWithAPriority_SayWhenItsQueueHasALock(
        QueueFullMode whenFull, int? priority, bool isNoted)
    {
        using var run = new TestRun(TimeKind.Virtual);
        var source = new ScriptedSource(run.Board, TimeSpan.FromSeconds(1));
        run.Reactor.Add(
            new Asking("m", priority, m => m.AttachReader("line", source, capacity: 8, whenFull)));

        AssertNotes(run, isNoted ? [("m", "m/line")] : []);
    }

    // Any thread may pop, and async code may: such a queue has a lock even where it rejects.
    [Theory, Trait("Clause", "1.8"), Trait("Clause", "4.2")]
    [InlineData(50, true)]
    [InlineData(null, false)]
    public void Notes_ReceiverOutsideManagers_SayWhoSendsToItWithAPriority(int? priority, bool isNoted)
    {
        using var run = new TestRun(TimeKind.Virtual);
        run.Reactor.Add(new Asking("sender", priority, m => m.Send<int>("orders")));
        run.Reactor.Workspace.Receive<int>("orders");

        AssertNotes(run, isNoted ? [("sender", "orders")] : []);
    }

    // A sender outside managers needs no lock; one that async code uses as a channel, which may wait, does.
    [Theory, Trait("Clause", "1.8"), Trait("Clause", "4.2")]
    [InlineData(false)]
    [InlineData(true)]
    public void Notes_SenderOutsideManagers_SayWhoReceivesFromAChannelWithAPriority(bool isChannel)
    {
        using var run = new TestRun(TimeKind.Virtual);
        run.Reactor.Add(new Asking("receiver", 50, m => m.Receive<int>("orders")));
        QueueSender<int> sender = run.Reactor.Workspace.Send<int>("orders");
        if (isChannel)
            sender.AsChannelWriter();

        AssertNotes(run, isChannel ? [("receiver", "orders")] : []);
    }

    // The thread that closes the queue takes out what is left.
    [Theory, Trait("Clause", "1.8"), Trait("Clause", "4.2")]
    [InlineData(50, true)]
    [InlineData(null, false)]
    public void Notes_ValuesThatAreDisposed_SayThatAQueueThatRejectsHasALockToo(int? priority, bool isNoted)
    {
        using var run = new TestRun(TimeKind.Virtual);
        run.Reactor.Add(new Asking("sender", priority, m => m.Send<Disposed>("orders")));
        run.Add("receiver").Receive<Disposed>("orders");

        AssertNotes(run, isNoted ? [("sender", "orders")] : []);
    }

    [Theory, Trait("Clause", "1.8")]
    [InlineData(true)]
    [InlineData(false)]
    public void LockOfAQueue_InheritsThePriority_WhereAManagerHasAskedForOne(bool hasPriority)
    {
        var sender = new EndpointOwner("sender", isManager: true, new WakeUpEvent()) { HasPriority = hasPriority };
        var receiver = new EndpointOwner("receiver", isManager: true, new WakeUpEvent());
        var receiving = new QueueBinding<int>(receiver, EndpointRole.Receive, "orders")
        {
            Capacity = 8,
            FullMode = QueueFullMode.DropOldest,
        };
        var clock = new RunClock(new ManualClock());

        var queue = (LockedQueue<int>)receiving.CreateConnector(
            [receiving, new QueueBinding<int>(sender, EndpointRole.Send, "orders")], clock,
            new RabitLog(null, logRuns: false, clock));

        Assert.Equal(hasPriority && PriorityInheritanceMutex.IsThere, queue.InheritsPriority);
    }

    private static void AssertNotes(TestRun run, params (string Manager, string Queue)[] expected)
    {
        run.Start();
        run.Finish();

        // All but for how long, which depends on the system.
        const string End = "',";
        Assert.Equal(
            expected.Select(e => $"manager '{e.Manager}' of a real-time priority may wait for the lock of queue "
                + $"'{e.Queue}"),
            NotesOfLocks(run).Select(n => n.Substring(0, n.IndexOf(End, StringComparison.Ordinal))));
    }

    private static string[] NotesOfLocks(TestRun run)
        => [.. run.Log.Where(e => e.Kind == RabitLogKind.Note).Select(e => e.Text)
            .Where(n => n.Contains("lock", StringComparison.Ordinal))];

    private sealed class Disposed : IDisposable
    {
        public void Dispose()
        {
        }
    }

    private sealed class Asking : RabitManager
    {
        public Asking(string name, int? priority, Action<Asking> declare)
            : base(name)
        {
            declare(this);
            RequestRealTime(new RealTimeRequest { Priority = priority });
        }

        public void Send<T>(string name) => base.Send<T>(name);

        public void Receive<T>(
            string name, int capacity = 100, QueueFullMode whenFull = QueueFullMode.Reject)
            => base.Receive<T>(name, capacity, whenFull);

        public void AttachReader<T>(string name, IReaderSource<T> source, int capacity, QueueFullMode whenFull)
            => base.AttachReader(name, source, capacity, whenFull);

        protected override void ExecuteUnitOfWork()
        {
        }
    }
}
