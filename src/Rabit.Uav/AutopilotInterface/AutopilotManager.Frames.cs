using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

// What is done with which message. Each frame is decoded once, here.
public sealed partial class AutopilotManager
{
    private VehicleEvents TakeFrame(in LinkFrame frame)
    {
        MavlinkFrame mavlink = frame.Frame;
        switch (mavlink.MessageId)
        {
            case Heartbeat.MavlinkId:
                mavlink.TryDecode(out Heartbeat heartbeat);
                return Take(frame, heartbeat);
            case GlobalPositionInt.MavlinkId:
                mavlink.TryDecode(out GlobalPositionInt position);
                return TakePose(frame, Complete(frame, _tracker.Update(frame, position)), PoseSampleKind.Position);
            case Attitude.MavlinkId:
                mavlink.TryDecode(out Attitude attitude);
                return TakePose(frame, Complete(frame, _tracker.Update(frame, attitude)), PoseSampleKind.Attitude);
            case LocalPositionNed.MavlinkId:
                mavlink.TryDecode(out LocalPositionNed local);
                return Take(frame, local);
            case SysStatus.MavlinkId:
                mavlink.TryDecode(out SysStatus status);
                return Take(frame, status);
            case BatteryStatus.MavlinkId:
                mavlink.TryDecode(out BatteryStatus battery);
                return Complete(frame, _tracker.Update(frame, battery));
            case GpsRawInt.MavlinkId:
                mavlink.TryDecode(out GpsRawInt gps);
                return Complete(frame, _tracker.Update(frame, gps));
            case SystemTime.MavlinkId:
                mavlink.TryDecode(out SystemTime clock);
                return Complete(frame, _tracker.Update(frame, clock));
            case ExtendedSysState.MavlinkId:
                mavlink.TryDecode(out ExtendedSysState extended);
                return Complete(frame, _tracker.Update(frame, extended));
            case Wind.MavlinkId:
                mavlink.TryDecode(out Wind wind);
                return Complete(frame, _tracker.Update(frame, wind));
            case WindCov.MavlinkId:
                mavlink.TryDecode(out WindCov windCov);
                return Complete(frame, _tracker.Update(frame, windCov));
            case EkfStatusReport.MavlinkId:
                mavlink.TryDecode(out EkfStatusReport ekf);
                return Complete(frame, _tracker.Update(frame, ekf));
            case EstimatorStatus.MavlinkId:
                mavlink.TryDecode(out EstimatorStatus estimator);
                return Complete(frame, _tracker.Update(frame, estimator));
            case Event.MavlinkId or CurrentEventSequence.MavlinkId or ResponseEventError.MavlinkId:
                return TakeEvent(frame);
            case FenceStatus.MavlinkId:
                mavlink.TryDecode(out FenceStatus fence);
                return Take(frame, fence);
            case PositionTargetLocalNed.MavlinkId:
                mavlink.TryDecode(out PositionTargetLocalNed target);
                return Take(frame, target);
            case PositionTargetGlobalInt.MavlinkId:
                mavlink.TryDecode(out PositionTargetGlobalInt place);
                return Take(frame, place);
            case GpsGlobalOrigin.MavlinkId:
                mavlink.TryDecode(out GpsGlobalOrigin origin);
                return Take(frame, origin);
            case Timesync.MavlinkId:
                mavlink.TryDecode(out Timesync time);
                return Take(frame, time);
            case Statustext.MavlinkId:
                return TakeText(frame);
            case AutopilotVersion.MavlinkId:
                mavlink.TryDecode(out AutopilotVersion version);
                return Take(frame, version);
            case CommandAck.MavlinkId:
                mavlink.TryDecode(out CommandAck acknowledgement);
                return Take(frame, acknowledgement);
            case GimbalDeviceAttitudeStatus.MavlinkId:
                mavlink.TryDecode(out GimbalDeviceAttitudeStatus gimbal);
                return TakeGimbal(frame, IsOfVehicle(frame) ? _gimbal.Take(frame, gimbal) : GimbalUpdate.OfOther);
            case MountOrientation.MavlinkId:
                mavlink.TryDecode(out MountOrientation mount);
                return TakeGimbal(frame, IsOfVehicle(frame) ? _gimbal.Take(frame, mount) : GimbalUpdate.OfOther);
            default:
                return Complete(frame, _tracker.Update(frame));
        }
    }

    // What every frame leads to, once the tracker has it.
    private VehicleEvents Complete(in LinkFrame frame, VehicleEvents events)
    {
        Handle(frame, events);
        if (_tracker.State.IsConnected)
            _rates?.Handle(frame.Frame, Now);
        TakeSetupFrame(frame);
        TakeFenceFrame(frame);
        TakeMetadataFrame(frame);
        TakeNavigation(frame);
        return events;
    }

    private void Handle(in LinkFrame frame, VehicleEvents events)
    {
        _statistics.Value.Frames++;
        _hasNewStatistics = true;
        Count(events);
        Handle(events, frame.Time);
    }

    private VehicleEvents Take(in LinkFrame frame, in Heartbeat heartbeat)
    {
        VehicleEvents events = Complete(frame, _tracker.Update(frame, heartbeat));
        if ((events & VehicleEvents.OfOther) == 0)
            _executor.TakeHeartbeat(_tracker.State, frame.Time);
        return events;
    }

    private VehicleEvents TakePose(in LinkFrame frame, VehicleEvents events, PoseSampleKind kind)
    {
        const VehicleEvents Unusable = VehicleEvents.OfOther | VehicleEvents.Refused;
        if ((events & VehicleEvents.Changed) != 0 && (events & Unusable) == 0)
            PushPose(kind, frame.Time);
        return events;
    }

    // Of any component of the vehicle: the gimbal itself, whose clock we do not know, or the autopilot for it.
    private VehicleEvents TakeGimbal(in LinkFrame frame, GimbalUpdate report)
    {
        VehicleEvents events = Complete(frame, _tracker.Update(frame));
        if (report == GimbalUpdate.Refused)
            Count(VehicleEvents.Refused);
        if (report != GimbalUpdate.Taken)
            return events;
        _tracker.NoteGimbal(frame.Time);
        PushGimbal(_gimbal.Attitude, _tracker.IsFromAutopilot(frame.Frame) ? _gimbal.BootTimeMs : 0, frame.Time);
        return events;
    }

    private bool IsOfVehicle(in LinkFrame frame)
        => _tracker.State.SystemId != 0 && _tracker.State.SystemId == frame.Frame.SystemId;

    private VehicleEvents Take(in LinkFrame frame, in Timesync message)
    {
        VehicleEvents events = Complete(frame, _tracker.Update(frame));
        if (_tracker.IsFromAutopilot(frame.Frame))
            _clock.Take(message, frame.Time);
        return events;
    }

    private VehicleEvents Take(in LinkFrame frame, in AutopilotVersion version)
    {
        VehicleEvents events = Complete(frame, _tracker.Update(frame));
        if (_tracker.IsFromAutopilot(frame.Frame) && _version.Take(version) is { } text)
            Log($"the autopilot's firmware is {text}");
        return events;
    }

    private VehicleEvents Take(in LinkFrame frame, in SysStatus status)
    {
        VehicleEvents events = Complete(frame, _tracker.Update(frame, status));
        if (_tracker.IsFromAutopilot(frame.Frame))
            _executor.TakeHealth(status, frame.Time);
        return events;
    }

    private VehicleEvents Take(in LinkFrame frame, in FenceStatus fence)
    {
        VehicleEvents events = Complete(frame, _tracker.Update(frame));
        if (_tracker.IsFromAutopilot(frame.Frame))
            _executor.TakeFence(fence.BreachStatus != 0);
        return events;
    }

    private VehicleEvents Take(in LinkFrame frame, in PositionTargetLocalNed target)
    {
        VehicleEvents events = Complete(frame, _tracker.Update(frame));
        if (_tracker.IsFromAutopilot(frame.Frame))
            _executor.TakeTarget(target, frame.Time);
        return events;
    }

    private VehicleEvents Take(in LinkFrame frame, in PositionTargetGlobalInt target)
    {
        VehicleEvents events = Complete(frame, _tracker.Update(frame));
        if (_tracker.IsFromAutopilot(frame.Frame))
            _executor.TakeTarget(target, frame.Time);
        return events;
    }

    private VehicleEvents Take(in LinkFrame frame, in GpsGlobalOrigin origin)
    {
        VehicleEvents events = Complete(frame, _tracker.Update(frame));
        if (_tracker.IsFromAutopilot(frame.Frame))
            _executor.TakeOrigin(origin);
        return events;
    }

    private VehicleEvents Take(in LinkFrame frame, in CommandAck acknowledgement)
    {
        VehicleEvents events = _tracker.Update(frame);
        Handle(frame, events);
        bool isFromAutopilot = _tracker.IsFromAutopilot(frame.Frame);
        OwnAddress own = _ownAddress.Value;
        bool isOfReport = isFromAutopilot && acknowledgement.Command == MavCmd.RequestMessage
            && acknowledgement.TargetSystem == own.SystemId && acknowledgement.TargetComponent == own.ComponentId;

        // Reports of the mode are asked for several times a second: their acknowledgements say nothing to people.
        if (isOfReport)
            _executor.TakeReportAcknowledgement(acknowledgement.Result, Now);
        else if (isFromAutopilot)
            Keep(acknowledgement, frame.Time);
        if (_tracker.State.IsConnected)
            _rates?.Handle(frame.Frame, acknowledgement, Now);
        if (!isOfReport)
            _executor.TakeAcknowledgement(frame.Frame, acknowledgement, Now);
        return events;
    }

    private void Keep(in CommandAck ack, TimeSpan time)
    {
        var item = new CommandAcknowledgement(time, ack.Command, ack.Result, ack.TargetSystem, ack.TargetComponent);
        _acknowledgements.Value = _acknowledgements.Value.With(item, RecentItemsKept);
    }
}
