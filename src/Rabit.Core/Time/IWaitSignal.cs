using System;

namespace Rabit.Core;

/// <summary>A wait engine: what a thread sleeps on. One thread waits, any thread sets.</summary>
internal interface IWaitSignal : IWakeSignal, IDisposable
{
    /// <summary>Waits for a signal; may return early without one, so the caller looks at its own state again.</summary>
    void Wait(TimeSpan atMost);
}
