using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Threading;

namespace Rabit.Core.Queues;

/// <summary>
/// Head, tail and counters of a <see cref="MultiProducerRing{T}"/> or <see cref="SingleProducerRing{T}"/>, which say
/// how they are used. What senders write, what the receiver writes and the neighbours lie on different cache lines (128
/// bytes: two lines that are fetched together), against false sharing.
/// </summary>
[StructLayout(LayoutKind.Explicit, Size = 5 * Apart)]
internal struct RingPositions
{
    private const int Apart = 128;
    private const int Closed = int.MinValue;

    // Where the next value goes. Moved by senders, by compare-and-swap; by a single producer, with an exchange or a
    // release.
    [FieldOffset(Apart)]
    private int _tail;

    // Where the head was when a sender last looked; it may have moved on. Written and read by senders.
    [FieldOffset(Apart + 4)]
    private int _seenHead;

    // Up to this many values there is room and no high-water mark to raise, so that a push need not look at the head:
    // the mark while the queue takes values in, then Closed. Written by senders and by the thread that closes the
    // queue, by interlocked operations.
    [FieldOffset(Apart + 8)]
    private int _fastPathLimit;

    // The mark when the queue was closed; -1 before. Written once.
    [FieldOffset(Apart + 12)]
    private int _lastHighWater;

    // Written by senders, by interlocked operations.
    [FieldOffset(3 * Apart)]
    private long _rejected;

    // Where the oldest value is. Written by the receiver.
    [FieldOffset(2 * Apart)]
    private int _head;

    // How often the head has crossed half of its range, written by the receiver after the head: with it the count of
    // pops has 63 bits.
    [FieldOffset((2 * Apart) + 4)]
    private int _halfWraps;

    // Where the tail was when the receiver last looked. The receiver's.
    [FieldOffset((2 * Apart) + 8)]
    private int _seenTail;

    // Written once.
    [FieldOffset(4 * Apart)]
    private readonly int _start;

    public RingPositions(int start)
    {
        _start = start;
        _tail = start;
        _seenHead = start;
        _head = start;
        _seenTail = start;
        _lastHighWater = -1;
    }

    /// <summary>The receiver's only.</summary>
    public readonly int Head => _head;

    /// <summary>How many slots hold so many values: a power of two.</summary>
    public static int SizeFor(int capacity)
    {
        int size = 1;
        while (size < capacity)
            size <<= 1;
        return size;
    }

    /// <summary>
    /// Reserves places, as many as there are of those that are wanted; counts the others as rejected.
    /// </summary>
    /// <param name="wanted">At least one.</param>
    /// <param name="capacity">How many values may be in the queue.</param>
    /// <param name="position">The first place.</param>
    /// <returns>How many places.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Reserve(int wanted, int capacity, out int position)
    {
        int tail = Volatile.Read(ref _tail);
        while (unchecked(tail - Volatile.Read(ref _seenHead) + wanted) <= Volatile.Read(ref _fastPathLimit))
        {
            int found = Interlocked.CompareExchange(ref _tail, unchecked(tail + wanted), tail);
            if (found == tail)
            {
                position = tail;
                return wanted;
            }

            tail = found;
        }

        return ReserveSlow(wanted, capacity, out position);
    }

    /// <summary>
    /// As <see cref="Reserve"/>, for a single producer: the places are its own until it moves the tail.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Find(int wanted, int capacity, out int position)
    {
        position = _tail;
        return unchecked(position - _seenHead + wanted) <= Volatile.Read(ref _fastPathLimit)
            ? wanted
            : ReserveExclusiveSlow(wanted, capacity);
    }

    /// <summary>A single producer has written values.</summary>
    /// <param name="next">The position after them.</param>
    /// <param name="fenced">Whether what the sender reads after this must not be read before it.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void MoveTail(int next, bool fenced)
    {
        if (fenced)
            Interlocked.Exchange(ref _tail, next);
        else
            Volatile.Write(ref _tail, next);
    }

    /// <summary>
    /// How many values of a single producer the receiver finds; it looks at the tail only when it knows of too few.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Available(int wanted)
    {
        int known = unchecked(_seenTail - _head);
        return known >= wanted ? known : unchecked((_seenTail = Volatile.Read(ref _tail)) - _head);
    }

    /// <summary>The receiver has taken values out and cleared their slots.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void MoveHead(int count)
    {
        int next = unchecked(_head + count);
        bool crosses = (next ^ _head) < 0;
        Volatile.Write(ref _head, next);
        if (crosses)
            Volatile.Write(ref _halfWraps, unchecked(_halfWraps + 1));
    }

    /// <summary>No push finds room any more.</summary>
    public void Close()
    {
        // In this order: a sender that raises the mark finds one of the two.
        Interlocked.CompareExchange(ref _lastHighWater, Volatile.Read(ref _fastPathLimit), -1);
        Interlocked.Exchange(ref _fastPathLimit, Closed);
    }

    /// <summary>The counters as they were at one instant during the call.</summary>
    public QueueCounters Counters(int capacity)
    {
        // Half wraps before the head: they may be one behind it, which the head's top bit shows.
        int half = unchecked((int)((uint)_start >> 31) + Volatile.Read(ref _halfWraps));
        int head = Volatile.Read(ref _head);
        int tail = Volatile.Read(ref _tail);
        if ((half & 1) != (int)((uint)head >> 31))
            half++;
        long popped = ((long)(half >> 1) << 32) + (uint)head - (uint)_start;

        // There may have been pops and pushes between the two looks; at the instant of the first there was no more than
        // fits in.
        int resident = Math.Min(unchecked(tail - head), capacity);
        int last = Volatile.Read(ref _lastHighWater);
        int highWater = Math.Max(resident, last >= 0 ? last : Volatile.Read(ref _fastPathLimit));
        return new QueueCounters(
            popped + resident, popped, dropped: 0, Interlocked.Read(ref _rejected), resident, highWater, capacity);
    }

    // Looks at the head itself, raises the high-water mark, and says whether the queue is full or closed.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private int ReserveSlow(int wanted, int capacity, out int position)
    {
        while (true)
        {
            int fastPathLimit = Volatile.Read(ref _fastPathLimit);
            int tail = Volatile.Read(ref _tail);
            int head = Volatile.Read(ref _head);
            Volatile.Write(ref _seenHead, head);

            // After the tail, so it may be ahead of it; then the compare-and-swap fails.
            int resident = Math.Max(unchecked(tail - head), 0);
            int count = Volatile.Read(ref _lastHighWater) >= 0 ? 0 : Math.Min(wanted, capacity - resident);
            position = tail;
            if (count <= 0)
            {
                Interlocked.Add(ref _rejected, wanted);
                return 0;
            }

            if (Interlocked.CompareExchange(ref _tail, unchecked(tail + count), tail) != tail)
                continue;
            if (count < wanted)
                Interlocked.Add(ref _rejected, wanted - count);
            RaiseHighWater(resident + count, fastPathLimit);
            return count;
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private int ReserveExclusiveSlow(int wanted, int capacity)
    {
        int fastPathLimit = Volatile.Read(ref _fastPathLimit);
        _seenHead = Volatile.Read(ref _head);
        int resident = unchecked(_tail - _seenHead);
        int count = Volatile.Read(ref _lastHighWater) >= 0 ? 0 : Math.Min(wanted, capacity - resident);
        if (count < wanted)
            Interlocked.Add(ref _rejected, wanted - count);
        RaiseHighWater(resident + count, fastPathLimit);
        return count;
    }

    private void RaiseHighWater(int resident, int fastPathLimit)
    {
        // Not once it is closed, when a mark would open it again.
        while (resident > fastPathLimit && Volatile.Read(ref _lastHighWater) < 0)
        {
            int found = Interlocked.CompareExchange(ref _fastPathLimit, resident, fastPathLimit);
            if (found == fastPathLimit)
                return;
            fastPathLimit = found;
        }
    }
}
