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
    private readonly Slot[] _slots;   // a power of two of them

    protected SequencedRing(
        string name, int capacity, WakeUpEvent<TSync>? receiverWakeUp, int start, bool isAlone)
        : base(name, capacity, QueueFullMode.Reject, receiverWakeUp)
    {
        int size = RingPositions.SizeFor(capacity);
        _slots = new Slot[size];
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

        value = TakeFrom(ref slot);
        State.MoveHead<TSync>(1);
        if (WakesSenders)
            WakeSenders();
        return true;
    }

    public sealed override int PopInto(Span<T> target)
    {
        int head = State.Head<TSync>();
        int popped = 0;
        for (; popped < target.Length; popped++)
        {
            int position = unchecked(head + popped);
            ref Slot slot = ref SlotAt(position);
            if (!IsThere(ref slot, position))
                break;
            target[popped] = TakeFrom(ref slot);
        }

        if (popped == 0)
            return 0;
        State.MoveHead<TSync>(popped);
        if (WakesSenders)
            WakeSenders();
        return popped;
    }

    /// <summary>Takes nothing more. What is left stays: it need not be returned.</summary>
    public sealed override void Close() => State.Close<TSync>();

    /// <summary>Head, tail and counters. A field: it is changed in place.</summary>
    protected RingPositions State;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    protected ref Slot SlotAt(int position)
    {
        Slot[] slots = _slots;
        return ref slots[position & (slots.Length - 1)];
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool IsThere(ref Slot slot, int position)
        => default(TSync).VolatileRead(ref slot.Sequence) == unchecked(position + 1) && State.Counts<TSync>(position);

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
