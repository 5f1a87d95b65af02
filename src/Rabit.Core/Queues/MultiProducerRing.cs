using System;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Queues;

/// <summary>
/// The queue that rejects when it is full, lock-free: many senders, and one receiver that alone takes out (a
/// multi-producer single-consumer ring, MPSC).
/// </summary>
/// <remarks>
/// Requirements (contract 1.4, 3.1, 3.2):
/// <list type="bullet">
/// <item>nothing is lost, doubled or torn; first in first out for each sender; never more than the capacity;</item>
/// <item>after a push that returned, some unit of work of the receiver that starts later sees the value;</item>
/// <item>no sender waits for another, or for the receiver; the receiver never waits for a sender.</item>
/// </list>
/// Positions count values from the start of the run, in 32 bits that wrap round (64-bit words are not atomic on the
/// 32-bit boards we run on), so they are compared by their difference only. A sender reserves places by moving the tail
/// with a compare-and-swap; it checks before that whether they are free, and they stay so, because the head only goes
/// forward. It writes the value, and then the slot's sequence, which says "the value of this position is here"; the
/// receiver reads the sequence before the value. The receiver clears the slot before it moves the head, and a sender
/// reads the head before it writes a slot. Each of these pairs is a release and an acquire. The races it closes:
/// <list type="bullet">
/// <item>Two senders at one place: the compare-and-swap lets one of them have it, the other tries again.</item>
/// <item>A sender is held up between reserving and writing. The receiver finds nothing at that place and leaves what
/// follows it, even if that was pushed long ago. It is seen all the same by a unit of work that starts later: the
/// sender that was held up wakes the receiver when it has written.</item>
/// <item>A push while the run ends and the queue is closed: closing moves the tail out of reach, so that the
/// compare-and-swap of a sender that has checked before fails. A value that was reserved before is among those that
/// were left, whether it has been written yet or not.</item>
/// <item>A wake is skipped where one is pending. The sequence is written by an exchange, a full fence, so the check of
/// the pending wake comes after it; taking wakes is an exchange too. If the check saw the old wake, the receiver takes
/// it later, and what it reads after that includes the value. (A check without the fence could be ahead of the write:
/// the receiver would take the wake, find nothing, and sleep.)</item>
/// </list>
/// A sender that is held up between its check and its compare-and-swap while exactly 2^32 values go by would be misled
/// (the ABA problem): 40 s at full speed, and then one chance in four thousand million.
/// </remarks>
internal sealed class MultiProducerRing<T, TSync> : SequencedRing<T, TSync>
    where TSync : struct, ISyncPoints
{
    /// <param name="name">For errors.</param>
    /// <param name="capacity">How many values fit in.</param>
    /// <param name="receiverWakeUp">Whom a push wakes.</param>
    /// <param name="start">The first position; tests let it wrap round soon.</param>
    public MultiProducerRing(string name, int capacity, WakeUpEvent<TSync>? receiverWakeUp, int start = 0)
        : base(name, capacity, receiverWakeUp, start, isAlone: false)
    {
    }

    public override PushResult Push(in T value)
    {
        if (State.Reserve<TSync>(1, Capacity, out int position) == 0)
            return PushResult.Rejected;
        ref Slot slot = ref SlotAt(position);
        Write(ref slot.Value, value);
        WakeUpEvent<TSync>? receiver = ReceiverWakeUp;
        if (receiver is null)
        {
            default(TSync).VolatileWrite(ref slot.Sequence, unchecked(position + 1));
            return PushResult.Queued;
        }

        default(TSync).Exchange(ref slot.Sequence, unchecked(position + 1));
        if (!IsPending(receiver, WakeUpCauses.Push))
            receiver.Wake(WakeUpCauses.Push);
        return PushResult.Queued;
    }

    public override int PushFrom(ReadOnlySpan<T> values)
    {
        if (values.IsEmpty)
            return 0;
        int count = State.Reserve<TSync>(values.Length, Capacity, out int position);
        for (int i = 0; i < count; i++)
        {
            ref Slot slot = ref SlotAt(unchecked(position + i));
            Write(ref slot.Value, values[i]);
            default(TSync).VolatileWrite(ref slot.Sequence, unchecked(position + i + 1));
        }

        if (count > 0 && ReceiverWakeUp is { } receiver)
        {
            default(TSync).Fence();
            if (!IsPending(receiver, WakeUpCauses.Push))
                receiver.Wake(WakeUpCauses.Push);
        }

        return count;
    }
}
