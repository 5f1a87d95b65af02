using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.CompilerServices;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;
using Rabit.Core.Workspaces;

namespace Rabit.Core.Messaging;

/// <summary>What an owner declared of a queue, and, once wired, its tie to it. Written by the thread that wires; then read by the owner's thread.</summary>
internal sealed class QueueBinding<T>(EndOwner owner, EndRole role, string name) : EndDeclaration(owner, role, name, typeof(T)), IQueueDeclaration
{
    /// <summary>Stated by the receiver.</summary>
    public int Capacity { get; init; }

    /// <summary>Stated by the receiver.</summary>
    public QueueFullMode FullMode { get; init; }

    /// <summary>Stated by the receiver: how long a push may wait for room.</summary>
    public TimeSpan? WaitAtMost { get; init; }

    /// <summary>Whether async code uses the end as a channel, and so may wait for the queue. Stated before it is wired.</summary>
    public bool IsChannel { get; private set; }

    public MessageQueue<T>? Queue { get; private set; }

    public override bool IsWired => Queue is not null;

    /// <summary>The queue, after the check that the owner may use it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public MessageQueue<T> Use()
    {
        MessageQueue<T>? queue = Queue;
        if (queue is null || (RunningManager.Current != Owner && Owner.IsManager))
            ThrowMisuse();
        return queue!;
    }

    /// <summary>The queue, for code that may wait for it.</summary>
    public LockedQueue<T> UseWaiting() => (LockedQueue<T>)Use();

    /// <summary>Async code is to use the end as a channel.</summary>
    /// <exception cref="InvalidOperationException">It belongs to a manager, or is wired already.</exception>
    public void BecomeChannel()
    {
        DemandOutside();
        if (IsWired)
            throw new InvalidOperationException($"The end of queue '{Name}' must become a channel before the reactor starts.");
        IsChannel = true;
    }

    /// <summary>Async code resumes on any thread, so it cannot use the end of a manager.</summary>
    public void DemandOutside()
    {
        if (!Owner.IsOutside)
            throw new InvalidOperationException($"The end of queue '{Name}' belongs to '{Owner.Name}': async code gets an end of its own from the workspace.");
    }

    public override object CreateHub(IReadOnlyList<EndDeclaration> ends, RunClock clock, RabitLog log)
    {
        var receiver = (QueueBinding<T>)ends.First(e => e.Role == EndRole.Receive);
        WakeUpEvent? wakeUp = receiver.Wakes ? receiver.Owner.WakeUp : null;

        // Without a lock where it is proved and pays; the rest needs more than one place at once, or somebody who waits. Values that must be
        // disposed are taken out by two: the receiver, and whoever closes the queue.
        bool needsNoLock = receiver.FullMode == QueueFullMode.Reject && !Discarded<T>.Matters && !receiver.Owner.IsOutside
            && !ends.Any(e => ((QueueBinding<T>)e).IsChannel);
        EndOwner[] senders = ends.Where(e => e.Role == EndRole.Send).Select(e => e.Owner).Distinct().ToArray();
        if (needsNoLock && senders.Length == 1 && !senders[0].IsOutside)
            return new PairQueue<T>(Name, receiver.Capacity, wakeUp, isOwnQueue: senders[0] == receiver.Owner);
        if (needsNoLock)
            return new RingQueue<T>(Name, receiver.Capacity, wakeUp);
        return new LockedQueue<T>(Name, receiver.Capacity, receiver.FullMode, wakeUp, receiver.WaitAtMost, clock, log);
    }

    public override void Watch(object hub, EventLog events) => events.Watch((IMessageQueue)hub);

    public override void Bind(object hub, EndDeclaration? firstOfOwner)
    {
        Queue = (MessageQueue<T>)hub;
        if (Role == EndRole.Send && Wakes && Owner.WakeUp is { } wakeUp)
            Queue.AddPopTarget(wakeUp);
    }
}
