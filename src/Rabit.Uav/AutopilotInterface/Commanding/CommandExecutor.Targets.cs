using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

// Targets of other commanders, which change no mode.
internal sealed partial class CommandExecutor
{
    private const string OtherTarget = "another commander's target";
    private const string OtherSetPoints = "another commander's set-points";

    // Reports of the mode before are not those of OFFBOARD.
    private static readonly TimeSpan OffboardSettlingTime = TimeSpan.OfSeconds(0.6);

    // By then it would have been answered.
    private static readonly TimeSpan TargetAnswerTime = TimeSpan.OfSeconds(0.3);

    private readonly TargetMonitor _targets = new();
    private readonly SetPointMonitor _setPoints = new();
    private readonly HoldTargetMonitor _holdTarget = new();
    private TimeSpan _sentAt;
    private bool _isTargetSeen;

    /// <summary>Takes the origin of the autopilot's local frame.</summary>
    public void TakeOrigin(in GpsGlobalOrigin origin) => _targets.TakeOrigin(origin);

    /// <summary>Takes the target that the autopilot flies to, in its local frame.</summary>
    public void TakeTarget(in PositionTargetLocalNed target, TimeSpan time)
    {
        if (_guard.Authority.State != CommandAuthorityState.Ours)
            return;
        if (_targets.IsOfAnother(target, time))
        {
            TakeAway(OtherTarget, time);
            return;
        }

        bool isInOffboard = _stream.HasLead(time) && time - _stream.OffboardSince > OffboardSettlingTime;
        if (isInOffboard)
            _setPoints.TakeReport(target, time);
        RequestConfirmation();
    }

    /// <summary>Takes the place that the autopilot flies to; PX4 reports it in its AUTO modes.</summary>
    public void TakeTarget(in PositionTargetGlobalInt target, TimeSpan time)
    {
        if (_guard.Authority.State != CommandAuthorityState.Ours)
            return;
        _holdTarget.TakeReport(target, time);
        if (_phase == ExecutorPhase.Sending && _sent > 0 && time - _sentAt >= TargetAnswerTime)
            _isTargetSeen = _profile is FixedWingProfile && FixedWingProfile.IsTarget(_steps[_step], target);
        RequestConfirmation();
    }

    // The target of a fixed wing is reported as it was sent.
    private void EndTarget(in CommandStep step, TimeSpan now)
    {
        if (step.Mode is { } mode)
            _guard.Acknowledge(mode, now);
        AcknowledgeTarget(step.Request.Command, now);
    }

    // A mode that has changed reports other targets, too, before it is reported itself.
    private void RequestConfirmation()
    {
        if (_setPoints.ForeignSince is not null || _holdTarget.ForeignSince is not null)
            _reports.RequestNow();
    }

    // A report of the mode that is still ours.
    private void ConfirmForeignTargets(in VehicleState vehicle, TimeSpan time)
    {
        if (_guard.Authority.State != CommandAuthorityState.Ours)
            return;
        if (_setPoints.ForeignSince < time && vehicle.CustomMode == Px4Modes.Offboard)
            TakeAway(OtherSetPoints, time);
        else if (_holdTarget.ForeignSince < time && vehicle.CustomMode == _profile?.CommandedMode)
            TakeAway(OtherTarget, time);
    }

    private void TakeAway(string by, TimeSpan time)
    {
        _guard.TakeAway(TakeoverCause.OtherCommander, by, time);
        StopCommanding(time);
    }

    private void StopWatchingTargets()
    {
        _targets.Stop();
        _setPoints.Restart();
        _holdTarget.Stop();
    }

    private bool IsArdupilotTarget(MavCmd command) => _profile is CopterProfile && command == MavCmd.DoReposition;

    // With the mode the autopilot forgets its target.
    private void AskForTarget(in CommandStep step, in VehicleState vehicle)
    {
        if (step.Mode is not null || _profile is FixedWingProfile)
        {
            _targets.Stop();
            _holdTarget.Stop();
        }
        else if (_sent == 0 && IsArdupilotTarget(step.Request.Command))
        {
            _targets.Ask(
                step.Request, vehicle.Position.AltitudeAmslMetres - vehicle.HeightAboveHomeMetres);
        }
    }

    private void AcknowledgeTarget(MavCmd command, TimeSpan now)
    {
        if (_profile is FixedWingProfile && command == MavCmd.DoReposition)
            _holdTarget.Begin(now);
        else if (IsArdupilotTarget(command))
            _targets.Acknowledge(now);
        else if (_profile is CopterProfile && command == MavCmd.NavTakeoff)
            _targets.BeginTakeOff(now);
    }

    private void WithdrawTarget(MavCmd command)
    {
        if (IsArdupilotTarget(command))
            _targets.Withdraw();
    }
}
