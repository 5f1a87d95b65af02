using System;
using Rabit.Core.Diagnostics;

namespace Rabit.Core.Queues;

/// <summary>
/// Disposes a value that will never be popped, if its type is disposable, so that a buffer goes back to its pool.
/// </summary>
internal static class Discarded<T>
{
    /// <summary>Whether there is anything to do; for all other types the compiler leaves the rest out.</summary>
    public static readonly bool Matters = typeof(IDisposable).IsAssignableFrom(typeof(T));

    /// <summary>Disposes a value. Not under a lock: Dispose is user code and may throw.</summary>
    public static void Dispose(T value, string place, RabitLog? log)
    {
        try
        {
            // Optimised code calls a struct in place, without a box.
            ((IDisposable?)value)?.Dispose();
        }
        catch (Exception e)
        {
            // The sender whose push dropped it did nothing wrong and must continue.
            log?.Write(
                RabitLogKind.Fault, place,
                "could not dispose a value that was dropped: " + ExceptionText.Describe(e), e);
        }
    }
}
