using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

// What the vehicle reports, and what follows from it by itself: who commands, streams, commands that grow stale.
internal sealed partial class CommandExecutor
{
    private readonly ModeReportRequester _reports = new();
    // The manager wakes up each 0.2 s at least.
    private static readonly TimeSpan MaxRunGap = TimeSpan.OfSeconds(0.35);

    private readonly FailsafeSigns _failsafes = new();
    private readonly CommandValidity _validity = new();
    private TimeSpan _lastRun;

    private bool RequestsReports => _sender is not null
        && (_guard.Authority.State == CommandAuthorityState.Ours || _phase is not ExecutorPhase.Idle);

    private TimeSpan ReportPeriod
        => _stream.IsRunning ? ModeReportRequester.StreamingPeriod : ModeReportRequester.Period;

    /// <summary>When the next set-point or request is due; far away where none is.</summary>
    /// <param name="now">The time.</param>
    public TimeSpan NextDue(TimeSpan now)
    {
        TimeSpan next = _stream.NextDue;
        if (!RequestsReports || _reports.IsDenied(now))
            return next;
        TimeSpan request = _reports.NextDue(ReportPeriod);
        return request < next ? request : next;
    }

    /// <summary>
    /// A unit of work begins, before its frames are taken. After a stall of ours, reports that waited in buffers count
    /// for who commands, and for nothing that is sent.
    /// </summary>
    public void BeginRun(TimeSpan now)
    {
        bool hasStalled = now - _lastRun > MaxRunGap;
        _lastRun = now;
        if (!hasStalled || _guard.Authority.State != CommandAuthorityState.Ours)
            return;
        _reports.Forget(now);
        _reportWantedAt = TimeSpan.MaxValue;
    }

    /// <summary>Takes the state after a heartbeat of the autopilot, which is a report of its mode.</summary>
    public void TakeHeartbeat(in VehicleState vehicle, TimeSpan time)
    {
        _reports.TakeReport(time);
        if (_guard.TakeReport(vehicle, _profile, _takeOffHeight, time))
        {
            ExplainTakeover(vehicle);
            StopCommanding(time);
            return;
        }

        ExplainTakeover(vehicle);
        ConfirmForeignTargets(vehicle, time);
        if (_guard.NeedsReport)
            _reports.RequestNow();
        _stream.TakeReport(vehicle, _guard.IsModeUnanswered);
        bool isStepUnderway = _phase is ExecutorPhase.Sending or ExecutorPhase.AwaitingMode;
        if (isStepUnderway && _sent > 0 && StepAsksForMode)
            _isModeSeen = _steps[_step].Mode == vehicle.CustomMode;
    }

    /// <summary>The autopilot has rebooted.</summary>
    /// <param name="wasFlying">Whether it was in the air, or might have been.</param>
    /// <param name="time">When.</param>
    public void TakeReboot(bool wasFlying, TimeSpan time)
    {
        _lastSpeed = double.NaN;
        _reports.Restart();
        _targets.Restart();
        _setPoints.Restart();
        if (_guard.TakeReboot(wasFlying, time))
            StopCommanding(time);
    }

    /// <summary>Takes the autopilot's acknowledgement of a request for a report of its mode.</summary>
    public void TakeReportAcknowledgement(MavResult result, TimeSpan now) => _reports.TakeAcknowledgement(result, now);

    /// <summary>Takes an acknowledgement, which may be the autopilot's to us.</summary>
    public void TakeAcknowledgement(in MavlinkFrame frame, in CommandAck acknowledgement, TimeSpan now)
        => _client?.Handle(frame, acknowledgement, now);

    /// <summary>
    /// Takes a text of the vehicle: the newest one that came with a refusal, and is no mere information, is its reason.
    /// </summary>
    public void TakeText(MavSeverity severity, string text, TimeSpan time)
    {
        _failsafes.TakeText(text, time);
        if (_phase != ExecutorPhase.Idle && severity <= MavSeverity.Warning)
            _reason = text;
    }

    /// <summary>Takes the text of an event: the reason of a refusal, where PX4 gives no other.</summary>
    public void TakeEventText(MavSeverity severity, string text)
    {
        if (_phase != ExecutorPhase.Idle && severity <= MavSeverity.Warning)
            _reason = text;
    }

    /// <summary>Takes an event of the autopilot.</summary>
    public void TakeEvent(uint id, TimeSpan time) => _failsafes.TakeEvent(id, time);

    /// <summary>Takes what the autopilot reports as healthy or not.</summary>
    public void TakeHealth(in SysStatus status, TimeSpan time) => _failsafes.TakeHealth(status, time);

    /// <summary>Takes what the fence of the autopilot reports.</summary>
    public void TakeFence(bool isBreached) => _failsafes.TakeFence(isBreached);

    // A failsafe says so before the change of the mode or after it.
    private void ExplainTakeover(in VehicleState vehicle)
    {
        CommandAuthority authority = _guard.Authority;
        if (authority.State != CommandAuthorityState.TakenAway || authority.Cause != TakeoverCause.Mode
            || _reports.ReportedAt - authority.Since > FailsafeSigns.Near)
            return;
        if (_failsafes.Find(vehicle, authority.Since) is { } failsafe)
            _guard.Explain(TakeoverCause.Failsafe, $"{authority.TakenBy} by a failsafe of the autopilot ({failsafe})");
    }

    private void RunStreams(in VehicleState vehicle, in OwnAddress own, TimeSpan now)
    {
        if (_velocity.TryNext(now, own, vehicle, out MavlinkFrame frame))
            Outbox.Frames.Enqueue(frame);
        TimeSpan maxAge = _reports.IsDenied(now) ? OffboardStream.MaxHeartbeatAge : OffboardStream.MaxReportAge;
        TimeSpan? proven = _reports.ProvenAt(now);
        if (_stream.TryPause(proven, maxAge, now))
        {
            Outbox.Notes.Enqueue("set-points pause: the autopilot reports no mode");
            _reports.Forget(now);
        }
        else if (_stream.IsPaused && now - proven <= maxAge)
        {
            _stream.Resume(vehicle, now);
        }

        if (!_stream.TryNext(now, own, vehicle, out frame))
            return;
        Outbox.Frames.Enqueue(frame);
        _setPoints.TakeSent(_stream.Place, _stream.HeightMetres, now);
    }

    // Only while we command, or are about to: who observes sends nothing.
    private void RequestReports(TimeSpan now)
    {
        if (RequestsReports && _reports.TryNext(now, ReportPeriod, _sender!, _target, out MavlinkFrame frame))
            Outbox.Frames.Enqueue(frame);
    }

    // The watcher is watched: commands that are not renewed are those of a Mission Control that no longer runs.
    private void WatchValidity(in VehicleState vehicle, TimeSpan now)
    {
        if (_guard.Authority.State != CommandAuthorityState.Ours || !CommandValidity.IsFlying(vehicle))
            return;
        if (_validity.TryExpire(now))
        {
            _guard.SetReturningByItself(true);
            Outbox.Notes.Enqueue(
                "the commands of Mission Control are no longer renewed: the vehicle is commanded to return");
        }

        if (!_validity.OwesReturn(now))
            return;
        if (_phase != ExecutorPhase.Idle)
        {
            if (_isOurOwn && _command.Kind == VehicleCommandKind.Return)
                return;
            Finish(VehicleCommandOutcome.Replaced, "its validity has passed: returning", now);
        }

        Begin(new VehicleCommand { Kind = VehicleCommandKind.Return }, isOurOwn: true, now);
    }
}
