using System;
using Rabit.Core.Diagnostics;

namespace Rabit.Core.Messaging;

/// <summary>
/// What becomes of a value that nobody will take: it is disposed, if its type can be, so that a buffer goes back to its pool.
/// </summary>
internal static class Discarded<T>
{
    /// <summary>Whether there is anything to do; for all other types the compiler leaves the rest out.</summary>
    public static readonly bool Matters = typeof(IDisposable).IsAssignableFrom(typeof(T));

    /// <summary>Disposes a value. Not under a lock: it is the code of somebody else, who may throw.</summary>
    public static void Dispose(T value, string place, RabitLog? log)
    {
        try
        {
            // Optimised code calls a struct in place, without a box.
            ((IDisposable?)value)?.Dispose();
        }
        catch (Exception e)
        {
            // Whoever dropped it did nothing wrong and must go on.
            log?.Write(RabitLogKind.Fault, place, $"could not dispose a value that was dropped: {e.GetType().Name}: {e.Message}", e);
        }
    }
}
