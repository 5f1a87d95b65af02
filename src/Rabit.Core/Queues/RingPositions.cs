using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Threading;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Queues;

/// <summary>
/// Head, tail and counters of a <see cref="MultiProducerRing{T, TSync}"/> or
/// <see cref="SingleProducerRing{T, TSync}"/>, which say how they are used. What senders write, what the receiver
/// writes, what hardly changes and the neighbours lie on different cache lines (128 bytes: two lines that are fetched
/// together), against false sharing.
/// </summary>
[StructLayout(LayoutKind.Explicit, Size = 5 * Apart)]
internal partial struct RingPositions
{
    private const int Apart = 128;
    private const int Closed = int.MinValue;

    // What closing adds to the tail. Two positions of the queue are never half the range apart, so the compare-and-swap
    // of a sender that has read the tail before fails, and the lower 31 bits of the distance to the head are right.
    private const int OutOfReach = int.MinValue;
    private const int Distance = int.MaxValue;

    // Where the next value goes. Of many producers: moved by them and by the thread that closes the queue, by
    // compare-and-swap; once the queue is closed, OutOfReach further on. Of a single one: moved by it alone, and no
    // longer what counts once the queue is closed (_lastTail).
    [FieldOffset(Apart)]
    private int _tail;

    // Where the head was when a sender last looked; it may have moved on. Written by senders, only forward: by many by
    // compare-and-swap.
    [FieldOffset(Apart + 4)]
    private int _seenHead;

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

    // Of a single producer, once the queue is closed: Settled, and in the lower half how far from the start the tail
    // was; Open before. Written once, by compare-and-swap, by the first that needs it.
    [FieldOffset(4 * Apart)]
    private long _lastTail;

    // Written once.
    [FieldOffset((4 * Apart) + 8)]
    private readonly int _start;

    // Written once.
    [FieldOffset((4 * Apart) + 12)]
    private readonly bool _isAlone;

    // Up to this many values there is room and no high-water mark to raise, so that a push need not look at the head:
    // the mark while the queue takes values in, then Closed. Written by senders and by the thread that closes the
    // queue, by interlocked operations.
    [FieldOffset((4 * Apart) + 16)]
    private int _fastPathLimit;

    // The mark when the queue was closed; -1 before. Written once.
    [FieldOffset((4 * Apart) + 20)]
    private int _lastHighWater;

    /// <param name="start">The first position.</param>
    /// <param name="isAlone">Whether there is a single producer.</param>
    public RingPositions(int start, bool isAlone)
    {
        _start = start;
        _isAlone = isAlone;
        _tail = start;
        _seenHead = start;
        _head = start;
        _lastHighWater = -1;
    }

    /// <summary>Whether there is a single producer.</summary>
    public readonly bool IsAlone => _isAlone;

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
    public int Reserve<TSync>(int wanted, int capacity, out int position)
        where TSync : struct, ISyncPoints
    {
        int tail = default(TSync).VolatileRead(ref _tail);

        // The limit after the tail: one who finds the tail out of reach finds the limit closed.
        while (unchecked(tail - default(TSync).VolatileRead(ref _seenHead) + wanted)
            <= default(TSync).VolatileRead(ref _fastPathLimit))
        {
            int found = default(TSync).CompareExchange(ref _tail, unchecked(tail + wanted), tail);
            if (found == tail)
            {
                position = tail;
                return wanted;
            }

            tail = found;
        }

        return ReserveSlow<TSync>(wanted, capacity, out position);
    }

    /// <summary>Where the oldest value is. The receiver's only.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Head<TSync>()
        where TSync : struct, ISyncPoints
        => default(TSync).Read(ref _head);

    /// <summary>Whether the queue was closed; nothing opens it again.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool IsClosed<TSync>()
        where TSync : struct, ISyncPoints
        => default(TSync).VolatileRead(ref _fastPathLimit) == Closed;

    /// <summary>
    /// Whether a value that the receiver finds at a position is its to take: not one of a single producer that was
    /// rejected because the queue was closed meanwhile.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Counts<TSync>(int position)
        where TSync : struct, ISyncPoints
        => !_isAlone || !IsClosed<TSync>() || IsBeforeLastTail<TSync>(position);

    /// <summary>The receiver has taken values out and cleared their slots.</summary>
    /// <param name="head">As it is.</param>
    /// <param name="count">How many values.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void MoveHead<TSync>(int head, int count)
        where TSync : struct, ISyncPoints
    {
        int next = unchecked(head + count);
        default(TSync).VolatileWrite(ref _head, next);
        if ((next ^ head) < 0)
            default(TSync).VolatileWrite(ref _halfWraps, unchecked(default(TSync).Read(ref _halfWraps) + 1));
    }

    /// <summary>No push finds room any more, and none that is under way puts a value in. Once only.</summary>
    public void Close<TSync>()
        where TSync : struct, ISyncPoints
    {
        // In this order: a sender that raises the mark finds one of the first two, and one that finds the tail out of
        // reach finds both.
        default(TSync).CompareExchange(ref _lastHighWater, default(TSync).VolatileRead(ref _fastPathLimit), -1);
        default(TSync).Exchange(ref _fastPathLimit, Closed);
        if (_isAlone)
        {
            LastTail<TSync>();
            return;
        }

        int tail = default(TSync).VolatileRead(ref _tail);
        while (true)
        {
            int found = default(TSync).CompareExchange(ref _tail, unchecked(tail + OutOfReach), tail);
            if (found == tail)
                return;
            tail = found;
        }
    }

    /// <summary>The counters as they were at one instant during the call.</summary>
    public QueueCounters Counters<TSync>(int capacity)
        where TSync : struct, ISyncPoints
    {
        int half, head, tail;
        do
        {
            // Half wraps before the head: they may be one behind it, which the head's top bit shows.
            half = unchecked((int)((uint)_start >> 31) + default(TSync).VolatileRead(ref _halfWraps));
            head = default(TSync).VolatileRead(ref _head);
            tail = _isAlone ? TailOfOne<TSync>() : default(TSync).VolatileRead(ref _tail);
        }
        while (default(TSync).VolatileRead(ref _head) != head);   // else there were pops between the looks

        if ((half & 1) != (int)((uint)head >> 31))
            half++;
        long popped = ((long)(half >> 1) << 32) + (uint)head - (uint)_start;

        // Once the queue of many producers is closed the tail is out of reach.
        int resident = unchecked(tail - head) & Distance;
        int last = default(TSync).VolatileRead(ref _lastHighWater);
        int highWater = Math.Max(resident, last >= 0 ? last : default(TSync).VolatileRead(ref _fastPathLimit));
        return new QueueCounters(
            popped + resident, popped, dropped: 0, Interlocked.Read(ref _rejected), resident, highWater, capacity);
    }

    // Looks at the head itself, raises the high-water mark, and says whether the queue is full or closed.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private int ReserveSlow<TSync>(int wanted, int capacity, out int position)
        where TSync : struct, ISyncPoints
    {
        while (true)
        {
            int fastPathLimit = default(TSync).VolatileRead(ref _fastPathLimit);
            int tail = default(TSync).VolatileRead(ref _tail);
            int head = LookAtHead<TSync>();

            // After the tail, so it may be ahead of it; then the compare-and-swap fails.
            int resident = Math.Max(unchecked(tail - head), 0);
            int count = HasLastMark<TSync>() ? 0 : Math.Min(wanted, capacity - resident);
            position = tail;
            if (count <= 0)
            {
                Interlocked.Add(ref _rejected, wanted);
                return 0;
            }

            if (default(TSync).CompareExchange(ref _tail, unchecked(tail + count), tail) != tail)
                continue;
            if (count < wanted)
                Interlocked.Add(ref _rejected, wanted - count);
            RaiseHighWater<TSync>(resident + count, fastPathLimit);
            return count;
        }
    }

    // Keeps what it finds, unless another sender has looked meanwhile: it may have found more, and one that is held up
    // here while half of the range goes by must not bring back an old head, with which the queue would look empty.
    private int LookAtHead<TSync>()
        where TSync : struct, ISyncPoints
    {
        int seen = default(TSync).VolatileRead(ref _seenHead);
        int head = default(TSync).VolatileRead(ref _head);
        if (head != seen)
            default(TSync).CompareExchange(ref _seenHead, head, seen);
        return head;
    }

    private bool HasLastMark<TSync>()
        where TSync : struct, ISyncPoints
        => default(TSync).VolatileRead(ref _lastHighWater) >= 0;

    private void RaiseHighWater<TSync>(int resident, int fastPathLimit)
        where TSync : struct, ISyncPoints
    {
        // Not once it is closed, when a mark would open it again.
        while (resident > fastPathLimit && !HasLastMark<TSync>())
        {
            int found = default(TSync).CompareExchange(ref _fastPathLimit, resident, fastPathLimit);
            if (found == fastPathLimit)
                return;
            fastPathLimit = found;
        }
    }
}
