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
        run.Reactor.Add(new Sender(priority));
        ScriptedManager receiver = run.Add("receiver");
        receiver.Receive<int>("orders", capacity: 8, whenFull);

        run.Start();
        run.Finish();

        string[] notes = [.. run.Log.Where(e => e.Kind == RabitLogKind.Note).Select(e => e.Text)
            .Where(n => n.Contains("lock", StringComparison.Ordinal))];
        Assert.Equal(isNoted ? 1 : 0, notes.Length);
        if (isNoted)
            Assert.StartsWith(
                "manager 'sender' of a real-time priority may wait for the lock of queue 'orders', for as long as ",
                notes[0], StringComparison.Ordinal);
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

    private sealed class Sender : RabitManager
    {
        public Sender(int? priority)
            : base("sender")
        {
            Send<int>("orders");
            RequestRealTime(new RealTimeRequest { Priority = priority });
        }

        protected override void ExecuteUnitOfWork()
        {
        }
    }
}
