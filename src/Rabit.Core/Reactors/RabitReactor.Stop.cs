using System;
using Rabit.Core.Managers;
using Rabit.Core.Reactors;

namespace Rabit.Core;

/// <content>What may be called when; the requests to stop, and the wait for them.</content>
public sealed partial class RabitReactor
{
    /// <summary>
    /// Asks for a stop and returns at once. Any thread; the first reason counts. Managers may delay the stop
    /// (<see cref="ReactorOptions.MaxStopDelay"/>); a call during such a delay ends it.
    /// </summary>
    /// <param name="reason">For the result.</param>
    public void Stop(string reason = "asked to stop") => RequestStop(reason, StopUrgency.EndsDelay);

    /// <summary>
    /// Stops a run that was started and not finished, and waits until all managers have ended, each within its time
    /// limit; the result is lost. A run that <see cref="Run"/> or <see cref="RunAsync"/> finishes is asked to stop and
    /// not waited for, and so is one that is disposed in the code of one of its managers. For the thread that would
    /// call <see cref="Finish"/>. A second call has no effect.
    /// </summary>
    public void Dispose()
    {
        bool mustEnd;
        lock (_gate)
        {
            if (_isDisposed)
                return;
            _isDisposed = true;
            if (!_hasStarted)
                return;
            mustEnd = _isWired && !_isFinished && !_isRunAsAWhole && RunningOwn() is null;
            _isFinished |= mustEnd;
        }

        RequestStop("disposed", StopUrgency.AtOnce);
        if (mustEnd)
            End();
    }

    // In one step: a Run that is refused must not seem to finish what another call started.
    private void Claim(bool asAWhole)
    {
        lock (_gate)
        {
            if (_isDisposed)
                throw new ObjectDisposedException(nameof(RabitReactor));
            if (_hasStarted)
                throw new InvalidOperationException(
                    "The reactor was started before; make a new one with new managers.");
            _hasStarted = true;
            _isRunAsAWhole = asAWhole;
        }
    }

    private void RequireRunning(bool finishing)
    {
        if (RunningOwn() is { } manager)
            throw new InvalidOperationException(
                $"Manager '{manager.Name}' cannot run or finish its own reactor: it would wait for itself. To stop the "
                    + "system a manager calls StopSystem, or Stop of its reactor, and returns.");
        lock (_gate)
        {
            string? refusal = !_isWired ? "The reactor has not started."
                : _hasEnded ? "The run has finished."
                : _isRunAsAWhole ? "Run or RunAsync runs this reactor, and finishes the run itself."
                : _isFinished ? "The run is being ended already."
                : null;
            if (refusal is not null)
                throw new InvalidOperationException(refusal);
            _isFinished = finishing;
        }
    }

    private ReactorResult End()
    {
        try
        {
            return EndAll();
        }
        finally
        {
            lock (_gate)
                _hasEnded = true;
        }
    }

    // For the length of one run.
    private StopSignals? TakeStopSignals() => _options.StopsOnSignals
        ? new StopSignals(StopOnSignal, note => _log.Write(RabitLogKind.Note, Source, note))
        : null;

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

    // Which manager of this reactor runs on this thread.
    private RabitManager? RunningOwn()
    {
        if (RunningManager.Current is not { } current)
            return null;
        foreach (RabitManager manager in _managers)
        {
            if (manager.Owner == current)
                return manager;
        }

        return null;
    }
}
