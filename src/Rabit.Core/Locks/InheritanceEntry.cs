using System;
using System.Threading;
using Rabit.Core.RealTimeKit;

namespace Rabit.Core.Locks;

/// <summary>
/// Enters a held lock with priority inheritance, whatever the kernel answers: see
/// <see cref="PriorityInheritanceMutex"/>.
/// </summary>
internal static unsafe class InheritanceEntry<TCalls>
    where TCalls : struct, IInheritanceCalls
{
    /// <summary>Where the holder stands in the word; the other bits are the kernel's (FUTEX_TID_MASK).</summary>
    public const int ThreadIdBits = 0x3FFFFFFF;

    /// <summary>Returns when the calling thread holds the lock.</summary>
    /// <param name="word">Of the lock.</param>
    /// <param name="thread">The kernel's id of the calling thread.</param>
    /// <exception cref="InvalidOperationException">The kernel gives an error that no wait answers.</exception>
    public static void Enter(int* word, int thread)
    {
        while (true)
        {
            int error = default(TCalls).Lock(word);
            switch (error)
            {
                case 0:   // also where a holder that ended has left a bit, which goes when the kernel hands it on
                case SystemErrors.NoSuchProcess when TryReplaceEnded(word, thread):
                    return;
                case SystemErrors.NoSuchProcess:
                case SystemErrors.Interrupted:
                case SystemErrors.TryAgain:      // the holder is just ending
                case SystemErrors.OutOfMemory:   // the kernel's, for the list of who waits
                    break;
                default:
                    throw PriorityInheritanceMutex.Failure("entered", error);
            }
        }
    }

    // The holder ended and no one waited: the kernel knows no such thread.
    private static bool TryReplaceEnded(int* word, int thread)
    {
        int found = Volatile.Read(ref *word);
        if (found != 0 && default(TCalls).IsAlive(found & ThreadIdBits))
            return false;
        return Interlocked.CompareExchange(ref *word, thread, found) == found;
    }
}
