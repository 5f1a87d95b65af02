using System;
using System.Runtime.InteropServices;
using System.Threading;

namespace Rabit.Latency.Native;

/// <summary>
/// A bare futex: one word that is 1 while a signal is there, and two calls. The limit of what a thread can be woken by.
/// </summary>
internal sealed unsafe class FutexWord : IDisposable
{
    private readonly int* _word = (int*)Marshal.AllocHGlobal(sizeof(int));

    public FutexWord() => *_word = 0;

    public void Set()
    {
        if (Interlocked.Exchange(ref *_word, 1) == 0)
            LinuxCalls.FutexWake(_word);
    }

    public void Wait()
    {
        while (Interlocked.Exchange(ref *_word, 0) == 0)
            LinuxCalls.FutexWait(_word, 0);
    }

    /// <summary>Waits for a signal or an absolute time of CLOCK_MONOTONIC.</summary>
    /// <returns>False when the time came first.</returns>
    public bool WaitUntil(long nanoseconds)
    {
        TimeSpec until = TimeSpec.FromNanoseconds(nanoseconds);
        while (Interlocked.Exchange(ref *_word, 0) == 0)
        {
            if (MonotonicClock.Now >= nanoseconds)
                return false;
            LinuxCalls.FutexWaitUntil(_word, 0, &until);
        }

        return true;
    }

    public void Dispose() => Marshal.FreeHGlobal((IntPtr)_word);
}
