using System;
using System.Reflection;

namespace Rabit.Tests.Shared;

/// <summary>Measures what a piece of work allocates on this thread.</summary>
internal static class Allocated
{
    // Not in the reference assemblies of net472, but in the Mono that runs them.
    private static readonly Func<long>? CountBytes = (Func<long>?)typeof(GC)
        .GetMethod("GetAllocatedBytesForCurrentThread", BindingFlags.Public | BindingFlags.Static)?
        .CreateDelegate(typeof(Func<long>));

    /// <summary>Bytes that this thread has allocated so far; always 0 where the runtime does not count them.</summary>
    public static long SoFar => CountBytes?.Invoke() ?? 0;

    /// <summary>Whether this runtime counts the bytes of a thread.</summary>
    public static bool IsSupported
    {
        get
        {
            long before = CountBytes?.Invoke() ?? 0;
            GC.KeepAlive(new byte[100_000]);
            return (CountBytes?.Invoke() ?? 0) - before >= 100_000;
        }
    }

    /// <summary>
    /// Bytes allocated by a piece of work that has run before, so that the runtime has loaded what it needs; 0 where it
    /// does not count them.
    /// </summary>
    /// <remarks>
    /// A collection in between, which any test beside this one may cause, closes this thread's allocation buffer and
    /// counts what was left of it. Such a measurement says nothing and is made again. A background collection closes
    /// the buffers once more in its midst, when no count shows it; so bytes count when three measurements without
    /// a counted collection have them: what the work itself allocates, it allocates each time.
    /// </remarks>
    /// <param name="work">The work; it may be done several times.</param>
    /// <param name="prepare">What must be done before each time, outside the measurement.</param>
    public static long By(Action work, Action? prepare = null)
    {
        long least = long.MaxValue;
        int confirmed = 0;
        for (int attempt = 0; attempt < 20 && confirmed < 3 && least > 0; attempt++)
        {
            prepare?.Invoke();
            int collections = GC.CollectionCount(0);
            long before = CountBytes?.Invoke() ?? 0;
            work();
            long allocated = (CountBytes?.Invoke() ?? 0) - before;
            least = Math.Min(least, allocated);
            if (GC.CollectionCount(0) == collections)
                confirmed++;
        }

        return least;
    }
}
