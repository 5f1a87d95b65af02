using System.Threading;

namespace Rabit.Core.Messages;

/// <summary>
/// netstandard2.0 has no barriers that are cheap enough, and some older runtimes that use it, Mono among them, have had
/// faults in those they have: posters and fetchers take the lock.
/// </summary>
internal static class OptimisticRead
{
    /// <summary>How often a fetcher tries before it takes the lock: never.</summary>
    public const int Tries = 0;

    /// <summary>How many posts are kept where a test makes a fetcher try all the same.</summary>
    public const int Slots = 8;

    /// <summary>No store after it is seen before one that precedes it.</summary>
    public static void StoreBarrier() => Interlocked.MemoryBarrier();

    /// <summary>Orders stores before loads on this thread; the lock does so on that of a poster.</summary>
    public static void FenceAllThreads() => Interlocked.MemoryBarrier();

    /// <summary>No load after it is made before one that precedes it.</summary>
    public static void LoadBarrier() => Interlocked.MemoryBarrier();
}
