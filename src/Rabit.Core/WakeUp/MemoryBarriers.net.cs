using System.Threading;

namespace Rabit.Core.WakeUp;

/// <summary>What orders memory beside volatile and interlocked operations.</summary>
internal static class MemoryBarriers
{
    /// <summary>Whether <see cref="AllThreads"/> is what its name says.</summary>
    public const bool ReachAllThreads = true;

    /// <summary>No store after it is seen before one that precedes it.</summary>
    public static void Store() => Volatile.WriteBarrier();

    /// <summary>No load after it is made before one that precedes it.</summary>
    public static void Load() => Volatile.ReadBarrier();

    /// <summary>
    /// A full fence on this thread and on all others, so that a thread on a hot path needs no fence of its own.
    /// </summary>
    public static void AllThreads() => Interlocked.MemoryBarrierProcessWide();
}
