using System;
using Rabit.Core.Synchronization;

namespace Rabit.Core;

/// <summary>
/// The wait engine of Linux: one word that is 1 while a signal is there. A timer is late by what the kernel takes, not by the
/// milliseconds that an event counts in.
/// </summary>
/// <remarks>
/// The race it closes: the sleeper looks at the word and goes to sleep, while a waker sets it. The kernel compares the word once more, under
/// its lock, before it lets the sleeper sleep, so either the sleeper sees the 1 or the waker's call finds the sleeper.
/// A waker that was held up may come when its sleeper has ended; the word lives as long as anyone has this object.
/// </remarks>
internal sealed unsafe class FutexWaitSignal<TSync> : IWaitSignal
    where TSync : struct, ISyncPoints
{
    private static readonly TimeSpan LongestWait = TimeSpan.FromHours(1);

    private readonly NativeWord _word = new();   // written by all, interlocked; read by the kernel

    public void Set()
    {
        if (default(TSync).Exchange(ref *_word.Address, 1) == 0)
            default(TSync).FutexWake(_word.Address);
        GC.KeepAlive(_word);
    }

    public void Wait(TimeSpan atMost)
    {
        int* word = _word.Address;
        if (default(TSync).Exchange(ref *word, 0) == 0 && atMost > TimeSpan.Zero)
        {
            default(TSync).FutexWaitWhileZero(word, atMost < LongestWait ? atMost : LongestWait);
            default(TSync).Exchange(ref *word, 0);
        }

        GC.KeepAlive(_word);
    }

    public void Dispose()
    {
        // A waker on its way may still need the word; see the remarks.
    }
}
