using System;
using System.Diagnostics.CodeAnalysis;
using Rabit.Core.Queues;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// A small lock-free queue of many senders, into which a fault can be put. Only for the explorer to find: nothing else
/// uses it.
/// </summary>
internal sealed class FaultyRing(
    SeededRingFault fault, int capacity, WakeUpEvent<ExploredSyncPoints>? receiver = null,
    WakeUpEvent<ExploredSyncPoints>? sender = null)
        : MessageQueue<int, ExploredSyncPoints>("twin", capacity, QueueFullMode.Reject, receiver)
{
    private readonly int[] _values = new int[capacity];
    private readonly int[] _sequences = new int[capacity];
    private int _tail;
    private int _head;

    public override int Count => throw new NotSupportedException();

    public override QueueCounters Counters => throw new NotSupportedException();

    private static ExploredSyncPoints Sync => default;

    public override PushResult Push(in int value)
    {
        if (!TryReserve(out int position, out bool wasEmpty))
            return PushResult.Rejected;
        int place = position % _values.Length;
        int sequence = position + 1;
        if (fault == SeededRingFault.SequenceBeforeTheValue)
        {
            Sync.Exchange(ref _sequences[place], sequence);
            Sync.Write(ref _values[place], value);
        }
        else
        {
            Sync.Write(ref _values[place], value);
            Publish(ref _sequences[place], sequence);
        }

        bool isPending = ReceiverWakeUp is null || IsPending(ReceiverWakeUp, WakeUpCauses.Push);
        if (!isPending && (wasEmpty || fault != SeededRingFault.WakesOnlyWhenEmpty))
            ReceiverWakeUp!.Wake(WakeUpCauses.Push);
        return PushResult.Queued;
    }

    public override bool TryPop([MaybeNullWhen(false)] out int value)
    {
        int head = Sync.Read(ref _head);
        int place = head % _values.Length;
        value = fault == SeededRingFault.ValueReadFirst ? Sync.Read(ref _values[place]) : 0;
        if (fault == SeededRingFault.SequenceNotChecked
            ? Sync.VolatileRead(ref _tail) == head
            : Sync.VolatileRead(ref _sequences[place]) != head + 1)
            return false;
        if (fault == SeededRingFault.HeadBeforeTheRead)
            Sync.VolatileWrite(ref _head, head + 1);
        if (fault != SeededRingFault.ValueReadFirst)
            value = Sync.Read(ref _values[place]);
        if (fault != SeededRingFault.HeadBeforeTheRead)
            Sync.VolatileWrite(ref _head, head + 1);
        if (sender is not null)
            WakeSender(sender);
        return true;
    }

    /// <summary>Of one sender.</summary>
    public override int PushFrom(ReadOnlySpan<int> values)
    {
        int tail = Sync.Read(ref _tail);
        int count = Math.Min(values.Length, Capacity - (tail - Sync.VolatileRead(ref _head)));
        Sync.VolatileWrite(ref _tail, tail + count);
        if (count > 1 && fault == SeededRingFault.LastBeforeTheOthers)
            Put(tail + count - 1, values[count - 1]);
        for (int i = 0; i < count; i++)
            Put(tail + i, values[i]);
        return count;
    }

    /// <summary>Of one sender.</summary>
    public override int PopInto(Span<int> target)
    {
        int head = Sync.Read(ref _head);
        int count = IsThere(head) ? target.Length : 0;
        if (count > 0 && !IsThere(head + count - 1))
        {
            count = 1;
            while (IsThere(head + count))
                count++;
        }

        for (int i = 0; i < count; i++)
            target[i] = Sync.Read(ref _values[(head + i) % _values.Length]);
        Sync.VolatileWrite(ref _head, head + count);
        return count;
    }

    public override void Close() => throw new NotSupportedException();

    private void Put(int position, int value)
    {
        int place = position % _values.Length;
        Sync.Write(ref _values[place], value);
        Sync.VolatileWrite(ref _sequences[place], position + 1);
    }

    private bool IsThere(int position)
        => Sync.VolatileRead(ref _sequences[position % _values.Length]) == position + 1;

    private bool TryReserve(out int position, out bool wasEmpty)
    {
        int most = Capacity + (fault == SeededRingFault.CapacityOffByOne ? 1 : 0);
        while (true)
        {
            position = Sync.VolatileRead(ref _tail);
            int resident = Math.Max(position - Sync.VolatileRead(ref _head), 0);
            wasEmpty = resident == 0;
            if (resident >= most)
                return false;
            if (fault == SeededRingFault.NoSwap)
            {
                Sync.VolatileWrite(ref _tail, position + 1);
                return true;
            }

            if (Sync.CompareExchange(ref _tail, position + 1, position) == position)
                return true;
        }
    }

    private void Publish(ref int sequence, int value)
    {
        if (fault == SeededRingFault.PlainSequence)
            Sync.Write(ref sequence, value);
        else if (fault == SeededRingFault.UnfencedCheckOfThePush)
            Sync.VolatileWrite(ref sequence, value);
        else
            Sync.Exchange(ref sequence, value);
    }

    private void WakeSender(WakeUpEvent<ExploredSyncPoints> toWake)
    {
        if (fault != SeededRingFault.UnfencedCheckOfThePop)
            Sync.Fence();
        if (!IsPending(toWake, WakeUpCauses.Pop))
            toWake.Wake(WakeUpCauses.Pop);
    }
}
