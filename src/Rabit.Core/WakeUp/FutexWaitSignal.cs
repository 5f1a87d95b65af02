using System;
using Rabit.Core.Time;

namespace Rabit.Core.WakeUp;

/// <summary>
/// The wait engine of Linux: one word that is 1 while a signal is there. A timer is late by what the kernel takes, not
/// by the milliseconds that an event counts in.
/// </summary>
/// <remarks>
/// The race it closes: the sleeper looks at the word and goes to sleep, while a waker sets it. The kernel compares the
/// word once more, under its lock, before it lets the sleeper sleep, so either the sleeper sees the 1 or the waker's
/// call finds the sleeper. A waker that was held up may come when its sleeper has ended; the word lives as long as
/// anyone has this object.
/// </remarks>
internal sealed unsafe class FutexWaitSignal<TSync>(RunClock clock) : IWaitSignal
    where TSync : struct, ISyncPoints
{
    private readonly NativeWord _word = new();   // written by all, interlocked; read by the kernel

    public void Set()
    {
        if (default(TSync).Exchange(ref *_word.Address, 1) == 0)
            default(TSync).FutexWake(_word.Address);
        GC.KeepAlive(_word);
    }

    // The kernel compares the deadline: no clock is read in front of the wait.
    public void Wait(TimeSpan until)
    {
        int* word = _word.Address;
        if (default(TSync).Exchange(ref *word, 0) == 0)
        {
            default(TSync).FutexWaitWhileZero(word, until, clock);
            default(TSync).Exchange(ref *word, 0);
        }

        GC.KeepAlive(_word);
    }

    public void Dispose()
    {
        // A waker on its way may still need the word; see the remarks.
    }
}
