using System;
using System.Diagnostics.CodeAnalysis;
using Rabit.Core.Queues;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// A small lock-free queue of many senders that push in batches, which can be closed
/// (<see cref="MultiProducerRing{T, TSync}"/>), into which a fault can be put. Only for the explorer to find: nothing
/// else uses it.
/// </summary>
internal sealed class FaultyClosingBatches(SeededBatchFault fault, int capacity)
    : MessageQueue<int, ExploredSyncPoints>("twin", capacity, QueueFullMode.Reject, receiverWakeUp: null)
{
    private const int OutOfReach = 1 << 20;   // added to the tail

    private readonly int[] _values = new int[capacity];
    private readonly int[] _sequences = new int[capacity];
    private int _tail;
    private int _head;
    private int _isClosed;

    public override int Count => throw new NotSupportedException();

    public override QueueCounters Counters
    {
        get
        {
            int tail = Sync.VolatileRead(ref _tail) & (OutOfReach - 1);
            return new QueueCounters(tail, 0, dropped: 0, 0, tail, tail, Capacity);
        }
    }

    private static ExploredSyncPoints Sync => default;

    public override PushResult Push(in int value) => PushFrom([value]) == 1 ? PushResult.Queued : PushResult.Rejected;

    public override bool TryPop([MaybeNullWhen(false)] out int value)
    {
        int[] one = new int[1];
        bool isThere = PopInto(one) == 1;
        value = one[0];
        return isThere;
    }

    public override int PushFrom(ReadOnlySpan<int> values)
    {
        if (fault != SeededBatchFault.ReservesOneByOne)
            return PushAll(values);
        foreach (int value in values)
        {
            if (PushAll([value]) == 0)
                return 0;
        }

        return values.Length;
    }

    public override int PopInto(Span<int> target)
    {
        int head = Sync.Read(ref _head);
        int count = 0;
        while (count < target.Length && IsThere(head + count))
            count++;
        for (int i = 0; i < count; i++)
            target[i] = Sync.Read(ref _values[(head + i) % _values.Length]);
        if (count > 0)
            Sync.VolatileWrite(ref _head, head + count);
        return count;
    }

    public override void Close()
    {
        if (fault == SeededBatchFault.CloseByAFlag)
        {
            Sync.Exchange(ref _isClosed, 1);
            return;
        }

        int tail = Sync.VolatileRead(ref _tail);
        while (Sync.CompareExchange(ref _tail, tail + OutOfReach, tail) is var found && found != tail)
            tail = found;
    }

    private int PushAll(ReadOnlySpan<int> values)
    {
        int count = Reserve(values.Length, out int position);
        for (int i = 0; i < count; i++)
        {
            int place = (position + i) % _values.Length;
            Sync.Write(ref _values[place], values[i]);
            Sync.VolatileWrite(ref _sequences[place], position + i + 1);
        }

        return count > 0 && fault == SeededBatchFault.CountsWhatWasOffered ? values.Length : count;
    }

    private int Reserve(int wanted, out int position)
    {
        while (true)
        {
            position = Sync.VolatileRead(ref _tail);
            int resident = Math.Max(position - Sync.VolatileRead(ref _head), 0);
            int count = IsClosed(position) ? 0 : Math.Min(wanted, Capacity - resident);
            if (count <= 0)
                return 0;
            if (fault == SeededBatchFault.NoSwap)
            {
                Sync.VolatileWrite(ref _tail, position + count);
                return count;
            }

            if (Sync.CompareExchange(ref _tail, position + count, position) == position)
                return count;
        }
    }

    private bool IsClosed(int tail)
        => fault == SeededBatchFault.CloseByAFlag ? Sync.VolatileRead(ref _isClosed) != 0 : tail >= OutOfReach;

    private bool IsThere(int position) => fault == SeededBatchFault.ReceiverByTheTail
        ? (Sync.VolatileRead(ref _tail) & (OutOfReach - 1)) > position
        : Sync.VolatileRead(ref _sequences[position % _values.Length]) == position + 1;
}
