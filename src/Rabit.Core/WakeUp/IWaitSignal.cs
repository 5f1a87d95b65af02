using System;

namespace Rabit.Core.WakeUp;

/// <summary>A wait engine: what a thread sleeps on. One thread waits, any thread sets.</summary>
internal interface IWaitSignal : IWakeSignal, IDisposable
{
    /// <summary>
    /// Waits for a signal; may return early without one, so the caller looks at its own state, and at the clock, again.
    /// </summary>
    /// <param name="until">
    /// When to return at the latest, by the clock of the run; one that is over is waited for no longer than the slack
    /// of the system's timers.
    /// </param>
    void Wait(TimeSpan until);
}
