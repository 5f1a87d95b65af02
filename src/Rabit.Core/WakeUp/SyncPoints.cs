using System;
using System.Runtime.CompilerServices;
using System.Threading;
using Rabit.Core.Time;

namespace Rabit.Core.WakeUp;

/// <summary>The points as they are on the machine: each is one inlined call of the API of the same name.</summary>
internal readonly unsafe struct SyncPoints : ISyncPoints
{
    public bool IsMachine => true;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public T Read<T>(ref T location) => location;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Write<T>(ref T location, in T value) => location = value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Fence() => Interlocked.MemoryBarrier();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int VolatileRead(ref int location) => Volatile.Read(ref location);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void VolatileWrite(ref int location, int value) => Volatile.Write(ref location, value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public long VolatileRead(ref long location)
        => IntPtr.Size == sizeof(long) ? Volatile.Read(ref location) : Interlocked.Read(ref location);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void VolatileWrite(ref long location, long value)
    {
        if (IntPtr.Size == sizeof(long))
            Volatile.Write(ref location, value);
        else
            Interlocked.Exchange(ref location, value);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public long InterlockedRead(ref long location) => Interlocked.Read(ref location);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void InterlockedWrite(ref long location, long value) => Interlocked.Exchange(ref location, value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Exchange(ref int location, int value) => Interlocked.Exchange(ref location, value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int CompareExchange(ref int location, int value, int comparand)
        => Interlocked.CompareExchange(ref location, value, comparand);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public long CompareExchange(ref long location, long value, long comparand)
        => Interlocked.CompareExchange(ref location, value, comparand);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void FenceAllThreads() => MemoryBarriers.AllThreads();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void StoreBarrier() => MemoryBarriers.Store();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void LoadBarrier() => MemoryBarriers.Load();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set(AutoResetEvent signal) => signal.Set();

    public void Wait(AutoResetEvent signal, int milliseconds)
    {
        try
        {
            signal.WaitOne(milliseconds);
        }
        catch (ThreadInterruptedException)
        {
            // Something that a unit of work called has interrupted the thread: an early return, as by a Unix signal.
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void FutexWake(int* word) => Futex.Wake(word);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void FutexWaitWhileZero(int* word, TimeSpan until, RunClock clock)
        => Futex.WaitWhileZero(word, until, clock);
}
