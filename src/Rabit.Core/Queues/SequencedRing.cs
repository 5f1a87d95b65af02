using System;
using System.Diagnostics.CodeAnalysis;
using System.Runtime.CompilerServices;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Queues;

/// <summary>
/// What the two lock-free rings have in common: slots that say which value is in them, and the receiver's side.
/// </summary>
/// <remarks>
/// The receiver finds a value by the sequence in its slot, not by the tail, so that it shares with the senders the
/// cache lines of the values alone, which must go from one processor to the other anyway; measured gain: decision 0009.
/// Which orders of memory this needs, and the races, is said at the two rings.
/// </remarks>
internal abstract class SequencedRing<T, TSync> : MessageQueue<T, TSync>
    where TSync : struct, ISyncPoints
{
    protected SequencedRing(
        string name, int capacity, WakeUpEvent<TSync>? receiverWakeUp, int start, bool isAlone)
        : base(name, capacity, QueueFullMode.Reject, receiverWakeUp)
    {
        int size = RingPositions.SizeFor(capacity);
        Slots = new Slot[size];
        for (int i = 0; i < size; i++)
            SlotAt(unchecked(start + i)).Sequence = unchecked(start + i);
        State = new RingPositions(start, isAlone);
    }

    public sealed override int Count => Counters.Resident;

    public sealed override QueueCounters Counters => State.Counters<TSync>(Capacity);

    public sealed override bool TryPop([MaybeNullWhen(false)] out T value)
    {
        int head = State.Head<TSync>();
        ref Slot slot = ref SlotAt(head);
        if (!IsThere(ref slot, head))
        {
            value = default;
            return false;
        }

        return State.IsClosed<TSync>() ? TryPopOfClosed(out value) : TakeOut(out value, ref slot, head);
    }

    public sealed override int PopInto(Span<T> target)
    {
        int head = State.Head<TSync>();
        int count = CountThere(head, Math.Min(target.Length, Slots.Length));
        if (count == 0)
            return 0;
        Slot[] slots = Slots;
        for (int i = 0; i < count; i++)
            target[i] = TakeFrom(ref slots[unchecked(head + i) & (slots.Length - 1)]);
        State.MoveHead<TSync>(head, count);
        if (WakesSenders)
            WakeSenders();
        return count;
    }

    /// <summary>Takes nothing more. What is left stays: it need not be returned.</summary>
    public sealed override void Close() => State.Close<TSync>();

    /// <summary>A power of two of them.</summary>
    protected Slot[] Slots { get; }

    /// <summary>Head, tail and counters. A field: it is changed in place.</summary>
    protected RingPositions State;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    protected ref Slot SlotAt(int position)
    {
        Slot[] slots = Slots;
        return ref slots[position & (slots.Length - 1)];
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsThere(ref Slot slot, int position)
        => default(TSync).VolatileRead(ref slot.Sequence) == unchecked(position + 1);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool IsThere(int position) => IsThere(ref SlotAt(position), position);

    // How many values the receiver finds from the head on, and may take.
    private int CountThere(int head, int most)
    {
        if (most == 0 || !IsThere(head))
            return 0;

        // A single producer writes its values in order: where the last is there, all are.
        int count = most;
        if (!State.IsAlone || !IsThere(unchecked(head + most - 1)))
        {
            count = 1;
            while (count < most && IsThere(unchecked(head + count)))
                count++;
        }

        if (!State.IsClosed<TSync>())
            return count;
        while (count > 0 && !State.Counts<TSync>(unchecked(head + count - 1)))
            count--;
        return count;
    }

    // Not inlined, and the last thing that is done: the hot path saves no registers for it.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool TryPopOfClosed([MaybeNullWhen(false)] out T value)
    {
        int head = State.Head<TSync>();
        if (State.Counts<TSync>(head))
            return TakeOut(out value, ref SlotAt(head), head);
        value = default;
        return false;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool TakeOut(out T value, ref Slot slot, int head)
    {
        value = TakeFrom(ref slot);
        State.MoveHead<TSync>(head, 1);
        if (WakesSenders)
            WakeSenders();
        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T TakeFrom(ref Slot slot)
    {
        T value = Read(ref slot.Value);
        if (References.In<T>())
            Write(ref slot.Value, default!);
        return value;
    }

    /// <summary>A place for a value.</summary>
    protected struct Slot
    {
        public T Value;

        /// <summary>
        /// The position of the value, plus one, once it is there. Written by the sender that has the place, read by the
        /// receiver.
        /// </summary>
        public int Sequence;
    }
}
