using System;
using System.Diagnostics.CodeAnalysis;
using Rabit.Core.Queues;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// A small lock-free queue of one sender that can be closed (<see cref="SingleProducerRing{T, TSync}"/>), into which a
/// fault can be put. Only for the explorer to find: nothing else uses it.
/// </summary>
internal sealed class FaultyClosingRing(SeededCloseFault fault, int capacity)
    : MessageQueue<int, ExploredSyncPoints>("twin", capacity, QueueFullMode.Reject, receiverWakeUp: null)
{
    private const int Open = 0;
    private const int Settled = 1;   // added to the tail

    private readonly int[] _values = new int[capacity];
    private readonly int[] _sequences = new int[capacity];
    private int _tail;
    private int _head;
    private int _isClosed;
    private int _lastTail;

    public override int Count => throw new NotSupportedException();

    public override QueueCounters Counters
    {
        get
        {
            int tail = Sync.VolatileRead(ref _tail);
            if (fault != SeededCloseFault.CountersByTheTail && IsClosed())
                tail = LastTail();
            return new QueueCounters(tail, 0, dropped: 0, 0, tail, tail, Capacity);
        }
    }

    private static ExploredSyncPoints Sync => default;

    public override PushResult Push(in int value)
    {
        int position = Sync.Read(ref _tail);
        if (IsClosed() || position - Sync.VolatileRead(ref _head) >= Capacity)
            return PushResult.Rejected;
        int tail = position + 1;
        Sync.Write(ref _values[position % _values.Length], value);
        if (fault == SeededCloseFault.SequenceBeforeTheTail)
            Show(position);
        Sync.VolatileWrite(ref _tail, tail);
        if (fault != SeededCloseFault.SequenceBeforeTheTail)
            Show(position);
        if (fault == SeededCloseFault.NoLookOfThePush || !IsClosed())
            return PushResult.Queued;
        return Settle(tail) >= tail || fault == SeededCloseFault.AlwaysInTime
            ? PushResult.Queued
            : PushResult.Rejected;
    }

    public override bool TryPop([MaybeNullWhen(false)] out int value)
    {
        value = 0;
        int head = Sync.Read(ref _head);
        int place = head % _values.Length;
        if (Sync.VolatileRead(ref _sequences[place]) != head + 1 || (GoesByTheLastTail() && head >= LastTail()))
            return false;
        value = Sync.Read(ref _values[place]);
        Sync.VolatileWrite(ref _head, head + 1);
        return true;
    }

    public override int PushFrom(ReadOnlySpan<int> values)
    {
        int position = Sync.Read(ref _tail);
        int count = IsClosed() ? 0 : Math.Min(values.Length, Capacity - (position - Sync.VolatileRead(ref _head)));
        if (count == 0)
            return 0;
        int tail = position + count;
        if (fault == SeededCloseFault.SequenceBeforeTheTail)
            PutAll(values.Slice(0, count), position, movesTheTail: false);
        if (fault != SeededCloseFault.BatchMovesTheTailOneByOne)
            Sync.VolatileWrite(ref _tail, tail);
        if (fault != SeededCloseFault.SequenceBeforeTheTail)
            PutAll(
                values.Slice(0, count), position,
                movesTheTail: fault == SeededCloseFault.BatchMovesTheTailOneByOne);
        if (fault == SeededCloseFault.NoLookOfThePush || !IsClosed())
            return count;
        return Settle(tail) >= tail || fault == SeededCloseFault.AlwaysInTime ? count : 0;
    }

    public override int PopInto(Span<int> target)
    {
        int head = Sync.Read(ref _head);
        bool wasClosed = fault == SeededCloseFault.BatchLooksForTheCloseFirst && IsClosed();
        int count = 0;
        while (count < target.Length && IsThere(head + count))
            count++;
        if (count > 0 && (fault == SeededCloseFault.BatchLooksForTheCloseFirst ? wasClosed : GoesByTheLastTail()))
        {
            int last = LastTail();
            if (fault != SeededCloseFault.BatchByItsFirstValue || head >= last)
                count = Math.Max(0, Math.Min(count, last - head));
        }

        for (int i = 0; i < count; i++)
            target[i] = Sync.Read(ref _values[(head + i) % _values.Length]);
        if (count > 0)
            Sync.VolatileWrite(ref _head, head + count);
        return count;
    }

    public override void Close()
    {
        Sync.Exchange(ref _isClosed, 1);
        LastTail();
    }

    private void PutAll(ReadOnlySpan<int> values, int position, bool movesTheTail)
    {
        for (int i = 0; i < values.Length; i++)
        {
            if (movesTheTail)
                Sync.VolatileWrite(ref _tail, position + i + 1);
            Sync.Write(ref _values[(position + i) % _values.Length], values[i]);
            Show(position + i);
        }
    }

    private bool IsThere(int position)
        => Sync.VolatileRead(ref _sequences[position % _values.Length]) == position + 1;

    private void Show(int position) => Sync.VolatileWrite(ref _sequences[position % _values.Length], position + 1);

    private bool IsClosed() => Sync.VolatileRead(ref _isClosed) != 0;

    // Of the receiver.
    private bool GoesByTheLastTail() => fault switch
    {
        SeededCloseFault.ReceiverBySequenceAlone => false,
        SeededCloseFault.ReceiverLooksForTheSettledTail => Sync.VolatileRead(ref _lastTail) != Open,
        _ => IsClosed(),
    };

    private int LastTail()
    {
        if (Sync.VolatileRead(ref _lastTail) is var last && last != Open)
            return last - Settled;
        if (fault != SeededCloseFault.NoFenceOnAllThreads)
            Sync.FenceAllThreads();
        return Settle(Sync.VolatileRead(ref _tail));
    }

    private int Settle(int tail)
    {
        if (fault == SeededCloseFault.TailNotSettled)
            return tail;
        int last = Sync.CompareExchange(ref _lastTail, tail + Settled, Open);
        return last == Open ? tail : last - Settled;
    }
}
