using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

// The phases of one command.
internal sealed partial class CommandExecutor
{
    private MavResult _refusal;

    /// <returns>Whether there may be more to do at once.</returns>
    private bool RunPhase(in VehicleState vehicle, TimeSpan now) => _phase switch
    {
        ExecutorPhase.Planning => Plan(vehicle, now),
        ExecutorPhase.Sending => Send(vehicle, now),
        ExecutorPhase.AwaitingMode => AwaitMode(vehicle, now),
        ExecutorPhase.AwaitingReason => AwaitReason(now),
        ExecutorPhase.StartingVelocity => StartVelocity(vehicle, now),
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

        _profile = VehicleProfile.For(vehicle, out string? refusal);
        refusal ??= _profile!.Plan(_command, new CommandContext(vehicle, now, _lastSpeed), _steps);
        if (refusal is not null)
        {
            Finish(VehicleCommandOutcome.Refused, refusal, now);
            return false;
        }

        if (_command.Kind != VehicleCommandKind.PointCamera)
            _lastSpeed = double.NaN;
        BeginStep(now);
        return true;
    }

    private void BeginStep(TimeSpan now)
    {
        _isModeSeen = false;
        _reason = null;
        if (_steps[_step].StartsVelocity)
        {
            Enter(ExecutorPhase.StartingVelocity, now);
            return;
        }

        _sent = 0;

        // At most one is at work and a handful may still be answered late: there is always room.
        _client!.TryStart(_steps[_step].Request with { Target = _target }, now, out _handle);
        Enter(ExecutorPhase.Sending, now);
    }

    private bool Send(in VehicleState vehicle, TimeSpan now)
    {
        CommandStep step = _steps[_step];
        while (_client!.TryTakeFrame(now, out MavlinkFrame frame))
        {
            _guard.Begin(vehicle.CustomMode, now);
            if (step.Mode is { } mode)
                _guard.Ask(mode, now);
            _sent++;
            Outbox.Frames.Enqueue(frame);
        }

        while (_client.TryTakeOutcome(out MavlinkCommandOutcome outcome))
        {
            if (outcome.Handle == _handle)
                return Take(outcome, step, vehicle, now);
        }

        return false;
    }

    private bool Take(in MavlinkCommandOutcome outcome, in CommandStep step, in VehicleState vehicle, TimeSpan now)
    {
        if (outcome.Result is not { } result)
        {
            Finish(
                VehicleCommandOutcome.TimedOut, $"no answer to {step.Request.Command}, sent {outcome.Sent} times", now);
            return false;
        }

        if (result == MavResult.Accepted || (step.IsDoneInTheAir && outcome.Sent > 1 && IsInTheAir(vehicle)))
        {
            if (step.IsModeAwaited)
                Enter(ExecutorPhase.AwaitingMode, now);
            else
                EndStep(now);
            return true;
        }

        if (step.Mode is { } refused)
            _guard.Withdraw(refused);
        _refusal = result;
        Enter(ExecutorPhase.AwaitingReason, now);
        return true;
    }

    private bool AwaitMode(in VehicleState vehicle, TimeSpan now)
    {
        if (_isModeSeen)
        {
            EndStep(now);
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
        string text = $"{_steps[_step].Request.Command}: {_refusal}";
        Finish(VehicleCommandOutcome.Refused, _reason is null ? text : $"{text} ({_reason})", now);
        return false;
    }

    private bool StartVelocity(in VehicleState vehicle, TimeSpan now)
    {
        if (vehicle.IsConnected && vehicle.CustomMode == _profile!.CommandedMode)
        {
            _guard.Begin(vehicle.CustomMode, now);
            _velocity.Start(_command, _begunAt, now);
            EndStep(now);
            return true;
        }

        if (now - _phaseSince < AutopilotWait)
            return false;
        Finish(VehicleCommandOutcome.TimedOut, "the autopilot is lost", now);
        return false;
    }

    private void EndStep(TimeSpan now)
    {
        if (++_step < _steps.Count)
        {
            BeginStep(now);
            return;
        }

        if (_command.Kind == VehicleCommandKind.GoTo)
            _lastSpeed = _command.SpeedMetresPerSecond;
        Finish(VehicleCommandOutcome.Accepted, text: null, now);
    }

    private static bool IsInTheAir(in VehicleState vehicle)
        => vehicle.LandedState is MavLandedState.Takeoff or MavLandedState.InAir;
}
