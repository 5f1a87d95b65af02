using System.Threading;

namespace Rabit.Core.WakeUp;

/// <summary>
/// What orders memory beside volatile and interlocked operations: full fences, since netstandard2.0 has nothing else.
/// It has none for all threads: nothing may count on one.
/// </summary>
internal static class MemoryBarriers
{
    /// <summary>Whether <see cref="AllThreads"/> is what its name says.</summary>
    public const bool ReachAllThreads = false;

    /// <summary>No store after it is seen before one that precedes it.</summary>
    public static void Store() => Interlocked.MemoryBarrier();

    /// <summary>No load after it is made before one that precedes it.</summary>
    public static void Load() => Interlocked.MemoryBarrier();

    /// <summary>A full fence on this thread alone.</summary>
    public static void AllThreads() => Interlocked.MemoryBarrier();
}
