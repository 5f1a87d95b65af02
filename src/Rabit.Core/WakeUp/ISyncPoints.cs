using System;
using System.Threading;
using Rabit.Core.Time;

namespace Rabit.Core.WakeUp;

/// <summary>
/// The points at which threads meet: every access to what they share without a lock, and every wait. Lock-free code is generic over a
/// struct of them, so that the same code runs on the machine (<see cref="SyncPoints"/>, which the compiler inlines to nothing) and under the
/// explorer of the tests, which tries every interleaving and every order in which a memory may show the accesses.
/// </summary>
/// <remarks>
/// How to use it: <c>class C&lt;TSync&gt; where TSync : struct, ISyncPoints</c>, and <c>default(TSync).VolatileRead(ref _x)</c> where
/// <c>Volatile.Read(ref _x)</c> would be. A field that is written once, before its object is handed to another thread, needs no point.
/// What each one promises is what the .NET memory model promises of the call of the same name, and no more:
/// <list type="bullet">
/// <item>plain: nothing but that an aligned 32-bit word is whole;</item>
/// <item>volatile: a read is not moved behind, a write not before, its neighbours; a write may still be delayed past later reads;</item>
/// <item>interlocked and <see cref="Fence"/>: in order with everything;</item>
/// <item>signals: what was done before a set is seen after the wait that it ends, and no more.</item>
/// </list>
/// The plain ones, the volatile write and the fence are what the explorer's own tests are made of: what a memory may show, and faults to find.
/// There are no volatile or plain 64-bit words: they are not whole on 32-bit machines.
/// </remarks>
internal unsafe interface ISyncPoints
{
    /// <summary>A plain read.</summary>
    int Read(ref int location);

    /// <summary>A plain write.</summary>
    void Write(ref int location, int value);

    int VolatileRead(ref int location);

    void VolatileWrite(ref int location, int value);

    int Exchange(ref int location, int value);

    /// <summary>An interlocked read.</summary>
    long InterlockedRead(ref long location);

    /// <summary>An interlocked write.</summary>
    void InterlockedWrite(ref long location, long value);

    int CompareExchange(ref int location, int value, int comparand);

    /// <summary>A full fence.</summary>
    void Fence();

    void Set(AutoResetEvent signal);

    void Wait(AutoResetEvent signal, int milliseconds);

    /// <summary>Wakes at most one thread that waits on the word.</summary>
    void FutexWake(int* word);

    /// <summary>Waits while the word is 0, which the kernel looks up, until a time of the run; may return early.</summary>
    void FutexWaitWhileZero(int* word, TimeSpan until, RunClock clock);
}
