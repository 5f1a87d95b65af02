using System;
using System.Diagnostics.CodeAnalysis;
using System.Runtime.CompilerServices;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Queues;

/// <summary>
/// A bounded first-in first-out queue: many senders, one receiver. What all kinds have in common; the wiring chooses
/// the kind (<see cref="QueueBinding{T}"/>).
/// </summary>
internal abstract class MessageQueue<T, TSync>(
    string name, int capacity, QueueFullMode fullMode, WakeUpEvent<TSync>? receiverWakeUp, TimeSpan? maxWait = null)
        : IMessageQueue
    where TSync : struct, ISyncPoints
{
    private WakeUpEvent<TSync>[] _popTargets = [];   // written while wiring, then read only

    public string Name { get; } = name;

    public QueueFullMode FullMode { get; } = fullMode;

    public int Capacity { get; } = capacity;

    /// <summary>How long a push may wait for room; null: until there is some.</summary>
    public TimeSpan? MaxWait { get; } = maxWait;

    /// <summary>How many values are in it.</summary>
    public abstract int Count { get; }

    public abstract QueueCounters Counters { get; }

    /// <summary>Whom a push wakes; null where the receiver did not ask for it.</summary>
    protected WakeUpEvent<TSync>? ReceiverWakeUp { get; } = receiverWakeUp;

    protected bool WakesSenders => _popTargets.Length != 0;

    public void AddPopTarget(WakeUpEvent<TSync> sender) => _popTargets = [.. _popTargets, sender];

    public abstract PushResult Push(in T value);

    /// <summary>
    /// Pushes one after the other, as <see cref="Push"/> does each, until one is rejected; the rest is rejected with
    /// it.
    /// </summary>
    /// <returns>How many were put in.</returns>
    public abstract int PushFrom(ReadOnlySpan<T> values);

    public abstract bool TryPop([MaybeNullWhen(false)] out T value);

    /// <returns>How many were taken out.</returns>
    public abstract int PopInto(Span<T> target);

    /// <inheritdoc/>
    public abstract void Close();

    /// <inheritdoc/>
    public virtual void DisposeRest()
    {
    }

    /// <summary>A plain read of a place for values.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    protected static T Read(ref T place) => default(TSync).IsMachine ? place : default(TSync).Read(ref place);

    /// <summary>A plain write.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    protected static void Write(ref T place, in T value)
    {
        if (default(TSync).IsMachine)
            place = value;
        else
            default(TSync).Write(ref place, value);
    }

    /// <summary>
    /// Whether a wake for a push is on its way to the receiver already, so that one more would merge with it. Only
    /// after a full fence (the two rings), or inside the lock in which the receiver pops (the locked queue): the three
    /// kinds say why.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    protected static bool IsPending(WakeUpEvent<TSync> wakeUp, WakeUpCauses cause) => wakeUp.Has((int)cause);

    /// <summary>Wakes the senders that asked for it. After the pop, outside every lock.</summary>
    protected void WakeSenders()
    {
        // The pop before the check: a sender that takes its wake-ups after our check sees the room.
        default(TSync).Fence();
        foreach (WakeUpEvent<TSync> sender in _popTargets)
        {
            if (!IsPending(sender, WakeUpCauses.Pop))
                sender.Wake(WakeUpCauses.Pop);
        }
    }
}
