using System.Threading;

namespace Rabit.Core.Messages;

/// <summary>
/// What it takes to read without a lock what a poster may be writing; see <see cref="SharedValue{T}"/>.
/// </summary>
internal static class OptimisticRead
{
    /// <summary>How often a fetcher tries before it takes the lock.</summary>
    public const int Tries = 4;

    /// <summary>
    /// How many posts are kept: a power of two. A fetcher's value is overwritten if one post less comes during one
    /// copy.
    /// </summary>
    public const int Slots = 8;

    /// <summary>No store after it is seen before one that precedes it.</summary>
    public static void StoreBarrier() => Volatile.WriteBarrier();

    /// <summary>
    /// Orders stores before loads on this thread and on all others, so that a poster on the hot path needs no fence of
    /// its own.
    /// </summary>
    public static void FenceAllThreads() => Interlocked.MemoryBarrierProcessWide();

    /// <summary>No load after it is made before one that precedes it.</summary>
    public static void LoadBarrier() => Volatile.ReadBarrier();
}
