using System;
using System.Threading;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Queues;

/// <summary>The points of the machine, with something that other threads do in front of a chosen one.</summary>
internal readonly unsafe struct HeldUpPoints : ISyncPoints
{
    [ThreadStatic]
    private static int _left;

    [ThreadStatic]
    private static Action? _meanwhile;

    /// <summary>Whether the chosen point was reached.</summary>
    public static bool WasHeldUp => _meanwhile is null;

    /// <summary>Holds this thread up.</summary>
    /// <param name="point">In front of which of its next points, 1 for the first.</param>
    /// <param name="meanwhile">What the others do.</param>
    public static void HoldUpAt(int point, Action meanwhile)
    {
        _left = point;
        _meanwhile = meanwhile;
    }

    public bool IsMachine => true;

    public T Read<T>(ref T location) => location;

    public void Write<T>(ref T location, in T value) => location = value;

    public void Fence() => default(SyncPoints).Fence();

    public int VolatileRead(ref int location)
    {
        Pass();
        return Volatile.Read(ref location);
    }

    public void VolatileWrite(ref int location, int value)
    {
        Pass();
        Volatile.Write(ref location, value);
    }

    public long VolatileRead(ref long location)
    {
        Pass();
        return default(SyncPoints).VolatileRead(ref location);
    }

    public void VolatileWrite(ref long location, long value)
    {
        Pass();
        default(SyncPoints).VolatileWrite(ref location, value);
    }

    public long CompareExchange(ref long location, long value, long comparand)
    {
        Pass();
        return default(SyncPoints).CompareExchange(ref location, value, comparand);
    }

    public void FenceAllThreads() => default(SyncPoints).FenceAllThreads();

    public void StoreBarrier() => default(SyncPoints).StoreBarrier();

    public void LoadBarrier() => default(SyncPoints).LoadBarrier();

    public int Exchange(ref int location, int value)
    {
        Pass();
        return Interlocked.Exchange(ref location, value);
    }

    public long InterlockedRead(ref long location)
    {
        Pass();
        return Interlocked.Read(ref location);
    }

    public void InterlockedWrite(ref long location, long value)
    {
        Pass();
        Interlocked.Exchange(ref location, value);
    }

    public int CompareExchange(ref int location, int value, int comparand)
    {
        Pass();
        return Interlocked.CompareExchange(ref location, value, comparand);
    }

    public void Set(AutoResetEvent signal) => throw new NotSupportedException();

    public void Wait(AutoResetEvent signal, int milliseconds) => throw new NotSupportedException();

    public void FutexWake(int* word) => throw new NotSupportedException();

    public void FutexWaitWhileZero(int* word, TimeSpan until, RunClock clock) => throw new NotSupportedException();

    private static void Pass()
    {
        if (_meanwhile is not { } meanwhile || --_left > 0)
            return;
        _meanwhile = null;
        meanwhile();
    }
}
