using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

// The phases of one command.
internal sealed partial class CommandExecutor
{
    private MavResult _refusal;

    /// <returns>Whether there may be more to do at once.</returns>
    private bool RunPhase(in VehicleState vehicle, in OwnAddress own, TimeSpan now) => _phase switch
    {
        CommandPhase.Planning => Plan(vehicle, own, now),
        CommandPhase.Clearing => Clear(now),
        CommandPhase.Sending => Send(vehicle, own, now),
        CommandPhase.AwaitingMode => AwaitMode(vehicle, now),
        CommandPhase.AwaitingReason => AwaitReason(now),
        CommandPhase.StartingVelocity => StartVelocity(vehicle, now),
        _ => false,
    };

    private bool Plan(in VehicleState vehicle, in OwnAddress own, TimeSpan now)
    {
        if (vehicle.SystemId == 0 || !own.IsKnown)
        {
            if (now - _phaseSince < AutopilotWait)
                return false;
            Finish(VehicleCommandOutcome.TimedOut, "no autopilot was heard");
            return false;
        }

        _profile = VehicleProfile.For(vehicle, out string? refusal);
        refusal ??= _profile!.Plan(_command, new CommandContext(vehicle, now, _lastSpeed), _steps);
        if (refusal is not null)
        {
            Finish(VehicleCommandOutcome.Refused, refusal);
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
        Enter(_steps[_step].StartsVelocity ? CommandPhase.StartingVelocity : CommandPhase.Clearing, now);
    }

    private bool Clear(TimeSpan now)
    {
        if (!_open.IsClear(_steps[_step].Request.Command, now))
            return false;
        _transaction.Begin(now);
        Enter(CommandPhase.Sending, now);
        return true;
    }

    private bool Send(in VehicleState vehicle, in OwnAddress own, TimeSpan now)
    {
        CommandStep step = _steps[_step];
        if (_transaction.TryNext(now, out byte confirmation))
        {
            _guard.Begin(vehicle.CustomMode, now);
            if (step.Mode is { } mode)
                _guard.Ask(mode, now);
            _open.Sent(step.Request.Command, now);
            Outbox.Frames.Enqueue(step.Request.ToFrame(own, vehicle, confirmation));
            return false;
        }

        if (!_transaction.IsOver)
            return false;
        if (_transaction.Result is not { } result)
        {
            Finish(VehicleCommandOutcome.TimedOut, $"no answer to {step.Request.Command}, sent {_transaction.Sent} times");
            return false;
        }

        if (result == MavResult.Accepted || (step.IsDoneInTheAir && _transaction.Sent > 1 && IsInTheAir(vehicle)))
        {
            if (step.IsModeAwaited)
                Enter(CommandPhase.AwaitingMode, now);
            else
                EndStep(now);
            return true;
        }

        if (step.Mode is { } refused)
            _guard.Withdraw(refused);
        _refusal = result;
        Enter(CommandPhase.AwaitingReason, now);
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
        Finish(VehicleCommandOutcome.TimedOut, $"the autopilot accepted the mode, but is in {vehicle.Mode} still");
        return false;
    }

    private bool AwaitReason(TimeSpan now)
    {
        if (_reason is null && now - _phaseSince < ReasonWait)
            return false;
        string text = $"{_steps[_step].Request.Command}: {_refusal}";
        Finish(VehicleCommandOutcome.Refused, _reason is null ? text : $"{text} ({_reason})");
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
        Finish(VehicleCommandOutcome.TimedOut, "the autopilot is lost");
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
        Finish(VehicleCommandOutcome.Accepted, text: null);
    }

    private static bool IsInTheAir(in VehicleState vehicle) => vehicle.LandedState is MavLandedState.Takeoff or MavLandedState.InAir;
}
