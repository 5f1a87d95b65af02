using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.CompilerServices;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;

namespace Rabit.Core.Queues;

/// <summary>
/// What an owner declared of a queue, and, once wired, the queue. Written by the thread that wires; then read by the
/// owner's thread.
/// </summary>
internal sealed class QueueBinding<T>(EndpointOwner owner, EndpointRole role, string name)
    : EndpointDeclaration(owner, role, name, typeof(T)), IQueueDeclaration
{
    // Who must run on the thread that uses this endpoint: null outside managers.
    private readonly EndpointOwner? _mustRun = owner.IsManager ? owner : null;

    // The queue, once wired, unless it makes its senders wait.
    private MessageQueue<T, SyncPoints>? _prompt;

    /// <summary>Stated by the receiver.</summary>
    public int Capacity { get; init; }

    /// <summary>Stated by the receiver.</summary>
    public QueueFullMode FullMode { get; init; }

    /// <summary>Stated by the receiver: how long a push may wait for room.</summary>
    public TimeSpan? MaxWait { get; init; }

    /// <summary>
    /// Whether async code uses the endpoint as a channel, and so may wait for the queue. Stated before it is wired.
    /// </summary>
    public bool IsChannel { get; private set; }

    public MessageQueue<T, SyncPoints>? Queue { get; private set; }

    /// <inheritdoc/>
    public bool IsHolding { get; private set; }

    /// <summary>The value that a sender holds because the queue was full.</summary>
    public T Held { get; private set; } = default!;

    public override bool IsWired => Queue is not null;

    /// <summary>
    /// The queue, where one glance shows that the owner may use it, and the queue never makes its senders wait. False
    /// decides nothing: then <see cref="Use"/> does. So the hot path calls nothing, and keeps its values in registers.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryUse(out MessageQueue<T, SyncPoints> queue)
    {
        MessageQueue<T, SyncPoints>? prompt = _prompt;
        queue = prompt!;   // looked at where it is there only
        return prompt is not null && (_mustRun is null || RunningManager.IsSeenToBe(_mustRun));
    }

    /// <summary>The queue, after the check that the owner may use it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public MessageQueue<T, SyncPoints> Use()
    {
        MessageQueue<T, SyncPoints>? queue = Queue;
        if (queue is null || (_mustRun is not null && !RunningManager.Is(_mustRun)))
            ThrowMisuse();
        return queue!;
    }

    /// <summary>The queue, for code that may wait for it.</summary>
    public LockedQueue<T> UseWaiting() => (LockedQueue<T>)Use();

    public void Hold(in T value)
    {
        Held = value;
        IsHolding = true;
    }

    public void ForgetHeld()
    {
        Held = default!;
        IsHolding = false;
    }

    /// <inheritdoc/>
    public void DisposeHeld()
    {
        if (!IsHolding)
            return;
        if (Discarded<T>.Matters)
            Discarded<T>.Dispose(Held, Name, log: null);
        ForgetHeld();
    }

    /// <summary>Async code will use the endpoint as a channel.</summary>
    /// <exception cref="InvalidOperationException">It belongs to a manager, or is wired already.</exception>
    public void BecomeChannel()
    {
        DemandOutside();
        if (IsWired)
            throw new InvalidOperationException(
                $"The endpoint of queue '{Name}' must become a channel before the reactor starts.");
        IsChannel = true;
    }

    /// <summary>Async code resumes on any thread, so it cannot use the endpoint of a manager.</summary>
    public void DemandOutside()
    {
        if (!Owner.IsOutside)
            throw new InvalidOperationException(
                $"The endpoint of queue '{Name}' belongs to '{Owner.Name}': async code gets an endpoint of its own "
                    + "from the workspace.");
    }

    public override IConnector CreateConnector(
        IReadOnlyList<EndpointDeclaration> endpoints, RunClock clock, RabitLog log)
    {
        QueueBinding<T> receiver = ReceiverOf(endpoints);
        WakeUpEvent? wakeUp = receiver.Wakes ? receiver.Owner.WakeUp : null;
        if (NeedsLock(endpoints))
        {
            return new LockedQueue<T>(
                Name, receiver.Capacity, receiver.FullMode, wakeUp, receiver.MaxWait, clock, log,
                inheritsPriority: endpoints.Any(e => e.Owner.HasPriority));
        }

        EndpointOwner[] senders = endpoints.Where(e => e.Role == EndpointRole.Send).Select(e => e.Owner)
            .Distinct().ToArray();
        return senders.Length == 1 && !senders[0].IsOutside
            ? new SingleProducerRing<T, SyncPoints>(
                Name, receiver.Capacity, wakeUp, isOwn: senders[0] == receiver.Owner)
            : new MultiProducerRing<T, SyncPoints>(Name, receiver.Capacity, wakeUp);
    }

    /// <inheritdoc/>
    public bool NeedsLock(IReadOnlyList<EndpointDeclaration> endpoints)
    {
        // Lock-free where that is proved and pays; the other rules change more than one place at once, or have waiters.
        // Disposable values are taken out by two threads: the receiver, and the one that closes the queue.
        QueueBinding<T> receiver = ReceiverOf(endpoints);
        return receiver.FullMode != QueueFullMode.Reject || Discarded<T>.Matters || receiver.Owner.IsOutside
            || endpoints.Any(e => ((QueueBinding<T>)e).IsChannel);
    }

    private static QueueBinding<T> ReceiverOf(IReadOnlyList<EndpointDeclaration> endpoints)
        => (QueueBinding<T>)endpoints.First(e => e.Role == EndpointRole.Receive);

    public override void Watch(IConnector connector, EventLog events) => events.Watch((IMessageQueue)connector);

    public override void Bind(IConnector connector, EndpointDeclaration? firstOfOwner)
    {
        Queue = (MessageQueue<T, SyncPoints>)connector;
        _prompt = Queue.FullMode == QueueFullMode.Wait ? null : Queue;
        if (Role == EndpointRole.Send && Wakes && Owner.WakeUp is { } wakeUp)
            Queue.AddPopTarget(wakeUp);
    }
}
