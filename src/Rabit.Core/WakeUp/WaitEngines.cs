using System;
using Rabit.Core.Time;

namespace Rabit.Core.WakeUp;

/// <summary>Chooses the wait engine of a run.</summary>
internal static class WaitEngines
{
    public const string Variable = "RABIT_WAIT_ENGINE";

    /// <summary>What is used for what was asked.</summary>
    /// <param name="asked">The option.</param>
    /// <param name="variable">
    /// The value of the environment variable; it counts where the option leaves the choice.
    /// </param>
    /// <param name="isFutexThere">Whether the kernel has futexes for us.</param>
    /// <param name="note">What the user should know; null for nothing.</param>
    public static WaitEngine Choose(WaitEngine asked, string? variable, bool isFutexThere, out string? note)
    {
        note = null;
        if (asked == WaitEngine.Best && !string.IsNullOrEmpty(variable))
        {
            if (string.Equals(variable, "event", StringComparison.OrdinalIgnoreCase))
                return WaitEngine.Event;
            if (string.Equals(variable, "futex", StringComparison.OrdinalIgnoreCase))
                asked = WaitEngine.Futex;
            else
                note = $"{Variable} is '{variable}'; it can be 'event' or 'futex'. The best engine is used.";
        }

        if (isFutexThere && asked != WaitEngine.Event)
            return WaitEngine.Futex;
        if (asked == WaitEngine.Futex)
            note = "The wait engine 'futex' does not work here; 'event' is used.";
        return WaitEngine.Event;
    }

    public static IWaitSignal Create(WaitEngine engine, RunClock clock)
        => engine == WaitEngine.Futex ? new FutexWaitSignal<SyncPoints>(clock) : new EventWaitSignal<SyncPoints>(clock);
}
