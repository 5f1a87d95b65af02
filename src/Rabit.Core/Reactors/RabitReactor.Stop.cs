using System;
using Rabit.Core.Reactors;

namespace Rabit.Core;

/// <content>The requests to stop, and the wait for them.</content>
public sealed partial class RabitReactor
{
    /// <summary>
    /// Asks for a stop and returns at once. Any thread; the first reason counts. Managers may delay the stop
    /// (<see cref="ReactorOptions.MaxStopDelay"/>); a call during such a delay ends it.
    /// </summary>
    /// <param name="reason">For the result.</param>
    public void Stop(string reason = "asked to stop") => RequestStop(reason, StopUrgency.EndsDelay);

    // A terminal that closes sends SIGHUP more than once; a person or a service manager that asks twice means it.
    private void StopOnSignal(string signal)
        => RequestStop(signal, signal == "SIGHUP" ? StopUrgency.Waits : StopUrgency.EndsDelay);

    private void RequestStop(string reason, StopUrgency urgency, Exception? failure = null)
    {
        lock (_gate)
        {
            _stopReason ??= reason;
            _failure ??= failure;
        }

        _stop.Request(urgency, reason);
    }

    // Returns early when the run stops, or when its stop was delayed as long as it may be.
    private void RunUntil(TimeSpan end)
    {
        _engine.RunUntil(end);
        _stop.CheckLimit();
    }
}
