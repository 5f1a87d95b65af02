using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

// The phases of one command.
internal sealed partial class CommandExecutor
{
    private MavResult _refusal;

    // A report older than this says too little for a command that changes the mode; one round trip takes milliseconds.
    private static readonly TimeSpan MaxReportAge = TimeSpan.FromMilliseconds(100);

    private TimeSpan _reportWantedAt = TimeSpan.MaxValue;

    /// <returns>Whether there may be more to do at once.</returns>
    private bool RunPhase(in VehicleState vehicle, TimeSpan now) => _phase switch
    {
        ExecutorPhase.Planning => Plan(vehicle, now),
        ExecutorPhase.Sending => Send(vehicle, now),
        ExecutorPhase.AwaitingMode => AwaitMode(vehicle, now),
        ExecutorPhase.AwaitingReason => AwaitReason(now),
        ExecutorPhase.StartingVelocity => StartVelocity(vehicle, now),
        ExecutorPhase.StartingStream => StartStream(vehicle, now),
        ExecutorPhase.TakingControl => TakeControl(vehicle, now),
        _ => false,
    };

    private bool Plan(in VehicleState vehicle, TimeSpan now)
    {
        if (_client is null)
        {
            if (now - _phaseSince < AutopilotWait)
                return false;
            Finish(VehicleCommandOutcome.TimedOut, "no autopilot is connected", now);
            return false;
        }

        _profile = VehicleProfile.For(vehicle, mayCommandFixedWing, out string? refusal);
        refusal ??= _profile!.Plan(
            _command,
            new CommandContext(
                vehicle, now, _lastSpeed, _stream.IsInOffboard,
                new MavlinkAddress(_sender!.SystemId, _sender.ComponentId)),
            _steps);
        if (refusal is not null)
        {
            Finish(VehicleCommandOutcome.Refused, refusal, now);
            return false;
        }

        if (_command.Kind != VehicleCommandKind.PointCamera)
            _lastSpeed = double.NaN;
        if (_command.Kind == VehicleCommandKind.TakeOff)
            _takeOffHeight = _command.HeightAboveHomeMetres;
        BeginStep(vehicle, now);
        return true;
    }

    private void BeginStep(in VehicleState vehicle, TimeSpan now)
    {
        _isModeSeen = false;
        _isTargetSeen = false;
        _reason = null;
        CommandStep step = _steps[_step];
        if (step.StartsVelocity)
        {
            Enter(ExecutorPhase.StartingVelocity, now);
            return;
        }

        if (step.StartsStream)
        {
            if (!_stream.IsRunning)
            {
                _stream.Start(vehicle, now);
                _setPoints.Restart();
            }

            Enter(ExecutorPhase.StartingStream, now);
            return;
        }

        if (step.SetsTarget)
        {
            _stream.SetTarget(_command, vehicle);
            EndStep(vehicle, now);
            return;
        }

        _sent = 0;
        _reportWantedAt = TimeSpan.MaxValue;

        // At most one is at work and a handful may still be answered late: there is always room.
        _client!.TryStart(step.Request with { Target = _target }, now, out _handle);
        Enter(ExecutorPhase.Sending, now);
    }

    private bool Send(in VehicleState vehicle, TimeSpan now)
    {
        CommandStep step = _steps[_step];
        if (step.NeedsReport && _client!.NextDue <= now && !HasFreshReport(now))
            return GiveUpWaiting(vehicle, now);
        if (step.OnlyInMode is { } only && vehicle.CustomMode != only)
        {
            Finish(
                VehicleCommandOutcome.Refused,
                $"{MavlinkNames.Of(step.Request.Command)} is not sent in {vehicle.Mode}", now);
            return false;
        }

        while (_client!.TryTakeFrame(now, out MavlinkFrame frame))
        {
            _guard.Begin(vehicle.CustomMode, now);
            if (step.Mode is { } mode)
                _guard.Ask(mode);
            AskForTarget(step, vehicle);
            _sent++;
            _sentAt = now;
            _reportWantedAt = TimeSpan.MaxValue;
            Outbox.Frames.Enqueue(frame);
        }

        while (_client.TryTakeOutcome(out MavlinkCommandOutcome outcome))
        {
            if (outcome.Handle == _handle)
                return Take(outcome, step, vehicle, now);
        }

        // Reported is as good as acknowledged: the answer may be lost, and nothing is sent again.
        if (_isTargetSeen)
            EndTarget(step, now);
        else if (!_isModeSeen || !step.IsModeAwaited)
            return false;
        _client.StopTracking(_handle, now);
        EndStep(vehicle, now);
        return true;
    }

    // Asked for right before the command, so that what it shows is a round trip old at most.
    private bool HasFreshReport(TimeSpan now)
    {
        if (_reportWantedAt == TimeSpan.MaxValue)
        {
            _reportWantedAt = now;
            _reports.RequestNow();
            return false;
        }

        return !_guard.NeedsReport && _reports.HasReportSince(_reportWantedAt)
            && now - _reports.ReportedAt <= MaxReportAge;
    }

    // A return, a landing or a hold that is due waits for the next report as long as the autopilot is connected.
    private bool GiveUpWaiting(in VehicleState vehicle, TimeSpan now)
    {
        if (_reports.ReportedAt < now - MaxReportAge)
            _reports.RequestNow();
        bool isDueAnyway = vehicle.IsConnected
            && _command.Kind is VehicleCommandKind.Return or VehicleCommandKind.Land or VehicleCommandKind.Hold;
        if (isDueAnyway || now - _reportWantedAt < AutopilotWait)
            return false;
        Finish(
            VehicleCommandOutcome.TimedOut,
            $"no report of the mode, without which {MavlinkNames.Of(_steps[_step].Request.Command)} is not sent", now);
        return false;
    }

    private bool Take(in MavlinkCommandOutcome outcome, in CommandStep step, in VehicleState vehicle, TimeSpan now)
    {
        if (outcome.Result is not { } result)
        {
            Finish(
                VehicleCommandOutcome.TimedOut,
                $"no answer to {MavlinkNames.Of(step.Request.Command)}, sent {outcome.Sent} times", now);
            return false;
        }

        if (result == MavResult.Accepted || (step.IsDoneInTheAir && outcome.Sent > 1 && IsInTheAir(vehicle)))
        {
            if (step.Mode is { } mode)
                _guard.Acknowledge(mode, now);
            AcknowledgeTarget(step.Request.Command, now);
            if (!step.IsModeAwaited)
            {
                EndStep(vehicle, now);
                return true;
            }

            _reports.RequestNow();
            Enter(ExecutorPhase.AwaitingMode, now);
            return true;
        }

        if (step.Mode is { } refused)
            _guard.Withdraw(refused);
        WithdrawTarget(step.Request.Command);
        _refusal = result;
        Enter(ExecutorPhase.AwaitingReason, now);
        return true;
    }

    private bool AwaitMode(in VehicleState vehicle, TimeSpan now)
    {
        if (_isModeSeen)
        {
            EndStep(vehicle, now);
            return true;
        }

        if (now - _phaseSince < ModeTimeout)
            return false;
        Finish(VehicleCommandOutcome.TimedOut, $"the autopilot accepted the mode, but is in {vehicle.Mode} still", now);
        return false;
    }

    private bool AwaitReason(TimeSpan now)
    {
        if (_reason is null && now - _phaseSince < ReasonWait)
            return false;
        string text = $"{MavlinkNames.Of(_steps[_step].Request.Command)}: {MavlinkNames.Of(_refusal)}";
        Finish(VehicleCommandOutcome.Refused, _reason is null ? text : $"{text} ({_reason})", now);
        return false;
    }

    private bool StartVelocity(in VehicleState vehicle, TimeSpan now)
    {
        if (vehicle.IsConnected && vehicle.CustomMode == _profile!.CommandedMode)
        {
            _guard.Begin(vehicle.CustomMode, now);
            _velocity.Start(_command, _begunAt, now);
            EndStep(vehicle, now);
            return true;
        }

        if (now - _phaseSince < AutopilotWait)
            return false;
        Finish(VehicleCommandOutcome.TimedOut, "the autopilot is lost", now);
        return false;
    }

    private bool StartStream(in VehicleState vehicle, TimeSpan now)
    {
        if (vehicle.SystemStatus is MavState.Critical or MavState.Emergency)
        {
            Finish(
                VehicleCommandOutcome.Refused,
                $"the autopilot reports {vehicle.SystemStatus}: no set-point is sent in a failsafe", now);
            return false;
        }

        if (_stream.HasLead(now))
        {
            EndStep(vehicle, now);
            return true;
        }

        if (now - _phaseSince < OffboardStream.LeadTime + AutopilotWait)
            return false;
        Finish(VehicleCommandOutcome.TimedOut, "the autopilot reports no mode", now);
        return false;
    }

    private bool TakeControl(in VehicleState vehicle, TimeSpan now)
    {
        if (_client is not null && HasFreshReport(now))
        {
            _guard.GiveControl(vehicle.CustomMode, now);
            Outbox.Notes.Enqueue($"the operator gave the command to us, in mode {vehicle.Mode}");
            Finish(VehicleCommandOutcome.Accepted, text: null, now);
            return false;
        }

        if (now - _phaseSince < AutopilotWait)
            return false;
        Finish(VehicleCommandOutcome.TimedOut, "no autopilot reports its mode", now);
        return false;
    }

    private void EndStep(in VehicleState vehicle, TimeSpan now)
    {
        if (++_step < _steps.Count)
        {
            BeginStep(vehicle, now);
            return;
        }

        if (_command.Kind == VehicleCommandKind.GoTo)
            _lastSpeed = _command.SpeedMetresPerSecond;
        if (_isOurOwn && _command.Kind == VehicleCommandKind.Return)
            _validity.EndReturn();
        if (_profile is Px4Profile or FixedWingProfile && _command.Kind == VehicleCommandKind.Hold)
            _holdTarget.Begin(now);
        Finish(VehicleCommandOutcome.Accepted, text: null, now);
    }

    private static bool IsInTheAir(in VehicleState vehicle)
        => vehicle.LandedState is MavLandedState.Takeoff or MavLandedState.InAir;
}
