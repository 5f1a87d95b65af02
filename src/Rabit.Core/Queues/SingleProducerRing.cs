using System;
using System.Diagnostics.CodeAnalysis;
using System.Runtime.CompilerServices;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Queues;

/// <summary>The queue that rejects when it is full, for one sender and one receiver, each a manager, reader or writer:
/// a lock-free single-producer single-consumer (SPSC) ring.</summary>
/// <remarks>
/// Requirements: those of <see cref="MultiProducerRing{T, TSync}"/>, with one sender. Only the sender moves the
/// tail, only the receiver moves the head; the check of who uses an endpoint enforces it. So the tail is moved by a
/// store, three times as fast between two processors as the compare-and-swap of many senders.
/// The sender writes a value before it moves the tail, the receiver reads the tail before the value; the receiver
/// clears a slot before it moves the head, the sender reads the head before it writes into the slot: a release and an
/// acquire each. The races it closes:
/// <list type="bullet">
/// <item>A wake is skipped where one is pending. Where another thread is woken the tail is moved by an exchange, a full
/// fence, so the look at the pending wake comes after it; taking wakes is an exchange too. If the look saw the old
/// wake, the receiver takes it later, and what it reads after that includes the value.</item>
/// <item>A push of a manager that did not stop in time, while the queue is closed: the positions settle whether it
/// counts (<see cref="RingPositions.TryMoveTail"/>).</item>
/// </list>
/// </remarks>
internal sealed class SingleProducerRing<T, TSync> : MessageQueue<T, TSync>
    where TSync : struct, ISyncPoints
{
    private readonly T[] _slots;   // a power of two of them
    private readonly bool _isFenced;   // whether the check for a pending wake needs a fence before it
    private RingPositions _state;

    /// <param name="name">For errors.</param>
    /// <param name="capacity">How many values fit in.</param>
    /// <param name="receiverWakeUp">Whom a push wakes.</param>
    /// <param name="start">The first position; tests let it wrap round soon.</param>
    /// <param name="isOwn">
    /// Whether the sender is the receiver: one thread at a time, which pushes, takes wakes and pops.
    /// </param>
    public SingleProducerRing(
        string name, int capacity, WakeUpEvent<TSync>? receiverWakeUp, int start = 0, bool isOwn = false)
        : base(name, capacity, QueueFullMode.Reject, receiverWakeUp)
    {
        _isFenced = receiverWakeUp is not null && !isOwn;
        _slots = new T[RingPositions.SizeFor(capacity)];
        _state = new RingPositions(start, isAlone: true);
    }

    public override int Count => Counters.Resident;

    public override QueueCounters Counters => _state.Counters<TSync>(Capacity);

    public override PushResult Push(in T value)
    {
        if (_state.Find<TSync>(1, Capacity, out int position) == 0)
            return PushResult.Rejected;
        Write(ref SlotAt(position), value);
        return TryPublish(position, 1) ? PushResult.Queued : PushResult.Rejected;
    }

    public override int PushFrom(ReadOnlySpan<T> values)
    {
        if (values.IsEmpty)
            return 0;
        int count = _state.Find<TSync>(values.Length, Capacity, out int position);
        for (int i = 0; i < count; i++)
            Write(ref SlotAt(unchecked(position + i)), values[i]);
        return count > 0 && TryPublish(position, count) ? count : 0;
    }

    public override bool TryPop([MaybeNullWhen(false)] out T value)
    {
        if (_state.Available<TSync>(1) == 0)
        {
            value = default;
            return false;
        }

        ref T slot = ref SlotAt(_state.Head<TSync>());
        value = Read(ref slot);
        if (References.In<T>())
            Write(ref slot, default!);
        _state.MoveHead<TSync>(1);
        if (WakesSenders)
            WakeSenders();
        return true;
    }

    public override int PopInto(Span<T> target)
    {
        int popped = Math.Min(_state.Available<TSync>(target.Length), target.Length);
        int head = _state.Head<TSync>();
        for (int i = 0; i < popped; i++)
        {
            ref T slot = ref SlotAt(unchecked(head + i));
            target[i] = Read(ref slot);
            if (References.In<T>())
                Write(ref slot, default!);
        }

        if (popped == 0)
            return 0;
        _state.MoveHead<TSync>(popped);
        if (WakesSenders)
            WakeSenders();
        return popped;
    }

    /// <summary>Takes nothing more. What is left stays: it need not be returned.</summary>
    public override void Close() => _state.Close<TSync>();

    /// <returns>False where the queue was closed meanwhile: the values are not in it.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool TryPublish(int position, int count)
    {
        if (!_state.TryMoveTail<TSync>(position, count, _isFenced))
            return false;
        if (ReceiverWakeUp is { } receiver && !IsPending(receiver, WakeUpCauses.Push))
            receiver.Wake(WakeUpCauses.Push);
        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private ref T SlotAt(int position)
    {
        T[] slots = _slots;
        return ref slots[position & (slots.Length - 1)];
    }
}
