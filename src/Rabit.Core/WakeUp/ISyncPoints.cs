using System;
using System.Threading;
using Rabit.Core.Time;

namespace Rabit.Core.WakeUp;

/// <summary>
/// The synchronization points of threads: every access to what they share without a lock, and every wait. Lock-free
/// code is generic over a struct of them, so that the same code runs on the machine (<see cref="SyncPoints"/>, which
/// the compiler inlines to nothing) and under the explorer of the tests, which tries every interleaving and every order
/// in which a memory may show the accesses.
/// </summary>
/// <remarks>
/// How to use it: <c>class C&lt;TSync&gt; where TSync : struct, ISyncPoints</c>, and
/// <c>default(TSync).VolatileRead(ref _x)</c> where <c>Volatile.Read(ref _x)</c> would be. A field that is written
/// once, before its object is handed to another thread, needs no point. What each one promises is what the .NET memory
/// model promises of the call of the same name, and no more:
/// <list type="bullet">
/// <item>volatile: a read is not moved past what follows it, nor a write before what it follows; a write may still be
/// delayed past later reads;</item>
/// <item>interlocked: in order with everything;</item>
/// <item>signals: what was done before a set is seen after the wait that it ends, and no more.</item>
/// </list>
/// A 64-bit word is whole on 32-bit machines too, where its volatile operations are interlocked ones.
/// </remarks>
internal unsafe interface ISyncPoints
{
    /// <summary>
    /// Whether a plain access may be made without these points, known when the code is compiled: where values are
    /// references a call of a generic method has to look its type up.
    /// </summary>
    bool IsMachine { get; }

    /// <summary>
    /// A plain read: what another thread has written may be seen late, in parts, and in another order.
    /// </summary>
    T Read<T>(ref T location);

    /// <summary>A plain write.</summary>
    void Write<T>(ref T location, in T value);

    /// <summary>A full fence, of this thread.</summary>
    void Fence();

    int VolatileRead(ref int location);

    void VolatileWrite(ref int location, int value);

    /// <summary>A volatile read of a word that is whole.</summary>
    long VolatileRead(ref long location);

    /// <summary>A volatile write of a word that is whole.</summary>
    void VolatileWrite(ref long location, long value);

    int Exchange(ref int location, int value);

    /// <summary>An interlocked read.</summary>
    long InterlockedRead(ref long location);

    /// <summary>An interlocked write.</summary>
    void InterlockedWrite(ref long location, long value);

    int CompareExchange(ref int location, int value, int comparand);

    long CompareExchange(ref long location, long value, long comparand);

    /// <summary>A full fence on all threads, where the machine has it (<see cref="MemoryBarriers"/>).</summary>
    void FenceAllThreads();

    /// <summary>No store after it is seen before one that precedes it.</summary>
    void StoreBarrier();

    /// <summary>No load after it is made before one that precedes it.</summary>
    void LoadBarrier();

    void Set(AutoResetEvent signal);

    /// <summary>Waits for a set; may return early.</summary>
    void Wait(AutoResetEvent signal, int milliseconds);

    /// <summary>Wakes at most one thread that waits on the word.</summary>
    void FutexWake(int* word);

    /// <summary>
    /// Waits while the word is 0, which the kernel compares, until a time of the run; may return early.
    /// </summary>
    void FutexWaitWhileZero(int* word, TimeSpan until, RunClock clock);
}
