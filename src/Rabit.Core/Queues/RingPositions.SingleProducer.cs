using System;
using System.Runtime.CompilerServices;
using System.Threading;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Queues;

/// <content>The positions of a single producer (<see cref="SingleProducerRing{T, TSync}"/>).</content>
/// <remarks>
/// It alone moves the tail, so a store does where many need a compare-and-swap. Requirements beside those of the ring
/// (contract 3.5): a push that races with the end of the run is rejected, or its value is among those that are left and
/// counted; no thread waits for another, since a manager that did not stop in time may be held up in its push for good.
/// A store cannot be refused, so what counts once the queue is closed is not the tail but <c>_lastTail</c>, which
/// the first thread that needs it settles by compare-and-swap, once for all:
/// <list type="bullet">
/// <item>The sender moves the tail, writes the sequences of the values, and then looks whether the queue is closed. If
/// it is, it proposes its own tail; its values count if that, or a later one, is what was settled, and are rejected
/// otherwise.</item>
/// <item>The thread that closes and readers of the counters read the tail and then look, too; so does the receiver once
/// it has found a value. If the queue is closed they fence all threads, read the tail again and propose that.</item>
/// </list>
/// The races it closes:
/// <list type="bullet">
/// <item>A sender whose look came before the queue was closed reports its value as queued, though its store of the tail
/// may still be on its way. The fence on all threads is between that look and the second read of the tail: the look was
/// made before it, and then the store can be read after it; or it is made after it, and finds the queue closed. Where
/// there is no such fence the sequence is written by an exchange, a full fence of the sender's own.</item>
/// <item>The receiver takes out a value that is settled not to count. It finds the value first and looks then, and the
/// tail was moved before the value could be found. If it finds the queue open, the thread that closes it reads the tail
/// later, with this value; if it finds it closed, it goes by what was settled.</item>
/// </list>
/// </remarks>
internal partial struct RingPositions
{
    private const long Open = 0;
    private const long Settled = 1L << 32;

    /// <summary>
    /// As <see cref="Reserve"/>: the places are the sender's, and nothing is in them until it has moved the tail and
    /// written their sequences.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Find<TSync>(int wanted, int capacity, out int position)
        where TSync : struct, ISyncPoints
        => TryFind<TSync>(wanted, out position) ? wanted : FindSlow<TSync>(wanted, capacity, position);

    /// <summary>
    /// As <see cref="Find"/>, where there is room that needs no look at the head. False decides nothing.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryFind<TSync>(int wanted, out int position)
        where TSync : struct, ISyncPoints
    {
        position = default(TSync).Read(ref _tail);
        return unchecked(position - default(TSync).Read(ref _seenHead) + wanted)
            <= default(TSync).VolatileRead(ref _fastPathLimit);
    }


    /// <summary>The sender has places for values; it says next, in their slots, when they are there.</summary>
    /// <param name="tail">Behind the last of them.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void MoveTail<TSync>(int tail)
        where TSync : struct, ISyncPoints
        => default(TSync).VolatileWrite(ref _tail, tail);

    /// <summary>
    /// Whether the values in front of the tail, which the sender has moved, count. Where fences do not reach all
    /// threads, after a full fence.
    /// </summary>
    /// <param name="tail">As moved.</param>
    /// <param name="count">How many values.</param>
    /// <returns>False where the queue was closed meanwhile: they are counted as rejected.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool AreInTime<TSync>(int tail, int count)
        where TSync : struct, ISyncPoints
        => !IsClosed<TSync>() || IsInTime<TSync>(tail, count);

    // In this order: a tail that was read while the queue was open is part of what will count.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int TailOfOne<TSync>()
        where TSync : struct, ISyncPoints
    {
        int tail = default(TSync).VolatileRead(ref _tail);
        return IsClosed<TSync>() ? LastTail<TSync>() : tail;
    }

    // Once the queue is closed.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private int LastTail<TSync>()
        where TSync : struct, ISyncPoints
    {
        if (default(TSync).VolatileRead(ref _lastTail) is var last && last != Open)
            return TailOf(last);
        default(TSync).FenceAllThreads();
        return Settle<TSync>(default(TSync).VolatileRead(ref _tail));
    }

    // The receiver, once the queue is closed.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool IsBeforeLastTail<TSync>(int position)
        where TSync : struct, ISyncPoints
        => unchecked(position - LastTail<TSync>()) < 0;

    // The sender, once the queue is closed: whether the values before this tail, which it has moved, count.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool IsInTime<TSync>(int tail, int count)
        where TSync : struct, ISyncPoints
    {
        if (unchecked(Settle<TSync>(tail) - tail) >= 0)
            return true;
        Interlocked.Add(ref _rejected, count);
        return false;
    }

    // What was settled before, or this tail.
    private int Settle<TSync>(int tail)
        where TSync : struct, ISyncPoints
    {
        long last = default(TSync).CompareExchange(ref _lastTail, Settled | unchecked((uint)(tail - _start)), Open);
        return last == Open ? tail : TailOf(last);
    }

    private readonly int TailOf(long settled) => unchecked((int)settled + _start);

    [MethodImpl(MethodImplOptions.NoInlining)]
    private int FindSlow<TSync>(int wanted, int capacity, int tail)
        where TSync : struct, ISyncPoints
    {
        int fastPathLimit = default(TSync).VolatileRead(ref _fastPathLimit);
        int head = default(TSync).VolatileRead(ref _head);
        default(TSync).Write(ref _seenHead, head);   // the sender's alone: it needs no compare-and-swap
        int resident = unchecked(tail - head);
        int count = HasLastMark<TSync>() ? 0 : Math.Min(wanted, capacity - resident);
        if (count < wanted)
            Interlocked.Add(ref _rejected, wanted - count);
        if (count > 0)
            RaiseHighWater<TSync>(resident + count, fastPathLimit);
        return count;
    }
}
