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

    /// <summary>Whether this runtime can tell.</summary>
    public static bool CanTell
    {
        get
        {
            long before = CountBytes?.Invoke() ?? 0;
            GC.KeepAlive(new byte[100_000]);
            return (CountBytes?.Invoke() ?? 0) - before >= 100_000;
        }
    }

    /// <summary>Bytes allocated by a piece of work that has run before, so that the runtime has loaded what it needs; 0 where it cannot tell.</summary>
    public static long By(Action work)
    {
        long before = CountBytes?.Invoke() ?? 0;
        work();
        return (CountBytes?.Invoke() ?? 0) - before;
    }
}
