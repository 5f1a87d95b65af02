using System;
using System.Diagnostics.CodeAnalysis;
using System.Threading;
using Rabit.Core.RealTimeKit;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Locks;

/// <summary>
/// A lock with priority inheritance: while a thread waits for it, the thread that holds it runs with the waiter's
/// priority, so that none of a priority in between delays them. Linux only; a thread that holds it may enter it again.
/// </summary>
/// <remarks>
/// Requirements: one holder at a time; who waits gets it in the order of priority; a free lock is entered and left
/// without a call of the kernel; nothing is allocated; a holder that ended without leaving is replaced.
/// <para>
/// The protocol is the kernel's (man 2 futex, "Priority-inheritance futexes"): the word is 0 where the lock is free, or
/// the kernel's id of the holding thread, with a bit that the kernel sets while others wait. A free word is taken, and
/// one without waiters is given back, by a compare-and-swap. All else is left to the kernel, which closes the race
/// between the two: it sets the waiters' bit before the waiter sleeps, so that the holder's compare-and-swap fails and
/// the holder asks the kernel to hand the lock over to the first of those who wait. What the kernel may answer, and a
/// holder that ended: <see cref="InheritanceEntry{TCalls}"/>.
/// </para>
/// <para>
/// It never spins: who waits may have displaced the very holder from its processor. So where many threads meet in it
/// flat out it is slower than a monitor, and it is used only where a manager may have asked for a priority.
/// </para>
/// </remarks>
[SuppressMessage("Reliability", "CA1001:Types that own disposable fields should be disposable",
    Justification = "It lives as long as what it guards; the word is freed by its finalizer.")]
internal sealed unsafe class PriorityInheritanceMutex
{
    // 0: free; else the holder, and the kernel's bits. Written by threads that enter and leave, and by the kernel.
    private readonly NativeWord _word = new();
    private int _entriesAgain;   // written by the holder

    /// <summary>Whether it works here: asked of the kernel.</summary>
    public static bool IsThere => InheritanceFutex.IsThere;

    /// <summary>Waits until no other thread holds it.</summary>
    public void Enter()
    {
        int thread = InheritanceFutex.ThreadId;
        if (Interlocked.CompareExchange(ref *_word.Address, thread, 0) != 0)
            EnterHeld(thread);
    }

    /// <summary>Gives it back, or to the first of those who wait. By the holder.</summary>
    public void Exit()
    {
        if (_entriesAgain > 0)
        {
            _entriesAgain--;
            return;
        }

        int thread = InheritanceFutex.ThreadId;
        if (Interlocked.CompareExchange(ref *_word.Address, 0, thread) != thread)
        {
            int error = InheritanceFutex.Unlock(_word.Address);
            if (error != 0)
                throw Failure("given back", error);
        }

        GC.KeepAlive(_word);
    }

    /// <summary>What the kernel does not do.</summary>
    public static InvalidOperationException Failure(string verb, int error)
        => new($"A lock cannot be {verb}: futex gives {SystemErrors.Name(error)}.");

    private void EnterHeld(int thread)
    {
        if ((Volatile.Read(ref *_word.Address) & InheritanceEntry<InheritanceCalls>.ThreadIdBits) == thread)
        {
            _entriesAgain++;
            return;
        }

        InheritanceEntry<InheritanceCalls>.Enter(_word.Address, thread);
        GC.KeepAlive(_word);
    }
}
