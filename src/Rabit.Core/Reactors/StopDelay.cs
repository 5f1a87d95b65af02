using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;
using Rabit.Core.Time;

namespace Rabit.Core.Reactors;

/// <summary>
/// Takes the requests to stop, and lets the stop wait while a manager delays it, within a limit. Any thread, but for
/// what says otherwise.
/// </summary>
internal sealed class StopDelay(TimeSpan limit, RunClock clock, RabitLog log, ReactorEngine engine)
{
    private const string Source = "reactor";
    private const long Never = -1;

    private readonly StopState _state = new();
    private IReadOnlyList<ManagerActivity> _managers = [];   // set before the barrier opens
    private long _beganTicks = Never;                        // written by the request that is delayed, read by Finish
    private bool _isOverLimit;                               // the reactor's thread only

    public bool IsRequested => _state.IsRequested;

    public bool IsStopping => _state.IsStopping;

    /// <summary>All managers have begun, and units of work follow: from now on a stop may wait.</summary>
    /// <returns>False when the run stops already.</returns>
    public bool TryOpen(IReadOnlyList<ManagerActivity> managers)
    {
        _managers = managers;
        return _state.TryOpen();
    }

    public void Request(StopUrgency urgency, string reason)
    {
        // The user's clock may be why the run is to stop; at zero the limit is over at once.
        TimeSpan now = clock.NowOr(TimeSpan.Zero);
        StopStep step = _state.Request(limit > TimeSpan.Zero ? urgency : StopUrgency.AtOnce);
        if (step == StopStep.Delayed)
            Begin(now, reason);
        StopIf(step);
    }

    /// <summary>A manager begins or ends to delay.</summary>
    /// <returns>Whether it counts; false when the run stops already, and nothing has changed.</returns>
    public bool TrySet(bool delays)
    {
        if (delays)
            return _state.TryAdd();
        bool isRemoved = _state.TryRemove(out StopStep step);
        StopIf(step);
        return isRemoved;
    }

    /// <summary>Ends a delay whose limit is over. The reactor's thread, whenever the engine has returned.</summary>
    public void CheckLimit()
    {
        if (!_state.IsDelayed || BeganAt is not { } began || clock.Now < Times.Later(began, limit))
            return;
        StopStep step = _state.EndDelay();
        _isOverLimit = step == StopStep.Stops;
        StopIf(step);
    }

    /// <summary>
    /// What became of the delay, for the log and the result. The reactor's thread, when the run stops.
    /// </summary>
    /// <param name="now">The time at which the run stops.</param>
    /// <param name="stillDelaying">The managers that it waits for no longer.</param>
    /// <returns>How long the stop waited.</returns>
    public TimeSpan Report(TimeSpan now, out IReadOnlyList<string> stillDelaying)
    {
        stillDelaying = _state.IsCutShort ? Delaying() : [];
        if (BeganAt is not { } began)
            return TimeSpan.Zero;
        TimeSpan waited = now - began;
        string text = FormattableString.Invariant($"the stop waited {waited.TotalSeconds:0.000} s");
        if (stillDelaying.Count > 0)
        {
            text += (_isOverLimit ? ", its limit," : " until it was requested again")
                + " and waits no longer for " + string.Join(", ", stillDelaying);
        }

        log.Write(RabitLogKind.Note, Source, text);
        return waited;
    }

    private TimeSpan? BeganAt
        => Interlocked.Read(ref _beganTicks) is var ticks && ticks == Never ? null : new TimeSpan(ticks);

    private void Begin(TimeSpan now, string reason)
    {
        Interlocked.Exchange(ref _beganTicks, now.Ticks);
        engine.LimitRun(Times.Later(now, limit));

        // Before the log, which may be slow: a manager has no longer than the limit.
        foreach (ManagerActivity manager in _managers)
            manager.WakeUp.Wake(WakeUpCauses.StopRequested);
        log.Write(
            RabitLogKind.Note, Source,
            FormattableString.Invariant($"is to stop: {reason}; waits {limit.TotalSeconds:0.000} s at most"));
    }

    private string[] Delaying() => _managers.Where(m => m.Manager.IsDelaying).Select(m => m.Name).ToArray();

    private void StopIf(StopStep step)
    {
        if (step == StopStep.Stops)
            engine.RequestStop();
    }
}
