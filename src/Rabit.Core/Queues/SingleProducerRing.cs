using System;
using System.Runtime.CompilerServices;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Queues;

/// <summary>The queue that rejects when it is full, for one sender and one receiver, each a manager, reader or writer:
/// a lock-free single-producer single-consumer (SPSC) ring.</summary>
/// <remarks>
/// Requirements: those of <see cref="MultiProducerRing{T, TSync}"/>, with one sender. Only the sender moves the
/// tail, only the receiver moves the head; the check of who uses an endpoint enforces it. So the tail is moved by a
/// store; measured gain: decision 0009.
/// The sender writes a value before its sequence, the receiver reads the sequence before the value; the receiver clears
/// a slot before it moves the head, the sender reads the head before it writes into the slot: a release and an acquire
/// each. The races it closes:
/// <list type="bullet">
/// <item>A wake is skipped where one is pending. Where another thread is woken the last store is an exchange, a full
/// fence, so the look at the pending wake comes after it; taking wakes is an exchange too. If the look saw the old
/// wake, the receiver takes it later, and what it reads after that includes the value.</item>
/// <item>A push of a manager that did not stop in time, while the queue is closed: the positions settle whether it
/// counts (<see cref="RingPositions.AreInTime"/>).</item>
/// </list>
/// </remarks>
internal sealed class SingleProducerRing<T, TSync> : SequencedRing<T, TSync>
    where TSync : struct, ISyncPoints
{
    // Whether what follows the last store of a push needs a full fence before it: the check for a pending wake, and the
    // look whether the queue was closed where no fence reaches all threads.
    private readonly bool _isFenced;

    /// <param name="name">For errors.</param>
    /// <param name="capacity">How many values fit in.</param>
    /// <param name="receiverWakeUp">Whom a push wakes.</param>
    /// <param name="start">The first position; tests let it wrap round soon.</param>
    /// <param name="isOwn">
    /// Whether the sender is the receiver: one thread at a time, which pushes, takes wakes and pops.
    /// </param>
    public SingleProducerRing(
        string name, int capacity, WakeUpEvent<TSync>? receiverWakeUp, int start = 0, bool isOwn = false)
        : base(name, capacity, receiverWakeUp, start, isAlone: true)
        => _isFenced = (receiverWakeUp is not null && !isOwn) || !MemoryBarriers.ReachAllThreads;

    public override PushResult Push(in T value)
        => State.TryFind<TSync>(1, out int position) ? Put(value, position) : PushBeyondMark(value);

    public override int PushFrom(ReadOnlySpan<T> values)
    {
        if (values.IsEmpty)
            return 0;
        int count = State.Find<TSync>(values.Length, Capacity, out int position);
        if (count == 0)
            return 0;
        int tail = unchecked(position + count);
        State.MoveTail<TSync>(tail);
        Slot[] slots = Slots;
        for (int i = 0; i < count; i++)
        {
            ref Slot slot = ref slots[unchecked(position + i) & (slots.Length - 1)];
            Write(ref slot.Value, values[i]);
            default(TSync).VolatileWrite(ref slot.Sequence, unchecked(position + i + 1));
        }

        if (_isFenced)
            default(TSync).Fence();
        return TryEnd(tail, count) ? count : 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private PushResult Put(in T value, int position)
    {
        ref Slot slot = ref SlotAt(position);
        Write(ref slot.Value, value);
        int tail = unchecked(position + 1);
        State.MoveTail<TSync>(tail);
        if (_isFenced)
            default(TSync).Exchange(ref slot.Sequence, tail);
        else
            default(TSync).VolatileWrite(ref slot.Sequence, tail);
        if (State.IsClosed<TSync>())
            return EndOfClosed(tail);
        return ReceiverWakeUp is { } receiver && !IsPending(receiver, WakeUpCauses.Push)
            ? Wake(receiver)
            : PushResult.Queued;
    }

    // What is rare is not inlined, and is the last thing that is done: the hot path saves no registers for it.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private PushResult PushBeyondMark(in T value)
        => State.Find<TSync>(1, Capacity, out int position) == 0 ? PushResult.Rejected : Put(value, position);

    [MethodImpl(MethodImplOptions.NoInlining)]
    private PushResult EndOfClosed(int tail) => TryEnd(tail, 1) ? PushResult.Queued : PushResult.Rejected;

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static PushResult Wake(WakeUpEvent<TSync> receiver)
    {
        receiver.Wake(WakeUpCauses.Push);
        return PushResult.Queued;
    }

    /// <returns>False where the queue was closed meanwhile: the values are not in it.</returns>
    private bool TryEnd(int tail, int count)
    {
        if (!State.AreInTime<TSync>(tail, count))
            return false;
        if (ReceiverWakeUp is { } receiver && !IsPending(receiver, WakeUpCauses.Push))
            receiver.Wake(WakeUpCauses.Push);
        return true;
    }
}
