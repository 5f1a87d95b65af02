using System;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// COMMAND_LONG, COMMAND_INT and SET_MODE: executes them, with the result codes of ArduCopter.
/// </summary>
internal sealed class CommandHandler(
    FlightController controller, TargetReader targets, StreamSchedule streams, TelemetrySender telemetry, Gimbal gimbal,
    IFrameSink sink, Action<MavSeverity, string> say)
{
    // "Force": MAVLink common.xml, MAV_CMD_COMPONENT_ARM_DISARM, param 2; ArduPilot takes 2989 for arming as well.
    private const float ForceMagic = 21196;
    private const float ForceArmMagic = 2989;

    // MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, param 6, to reboot an armed vehicle.
    private const float ForceRebootMagic = 20190226;
    private const float MaxNumber = 1 << 24;   // message ids have 24 bits

    /// <summary>Whether a reboot was accepted.</summary>
    public bool WantsReboot { get; private set; }

    /// <summary>Executes a command, and says with what result.</summary>
    public MavResult Execute(in MavlinkCommand received)
    {
        bool isLong = received.Forms == MavlinkCommandForms.LongOnly;
        if (received.Command == MavCmd.DoGimbalManagerPitchyaw)
            return PointCamera(received.Param1, received.Param2, isLong ? received.Param5 : received.X);
        var command = new CommandInt
        {
            Command = received.Command,
            Frame = isLong ? MavFrame.GlobalRelativeAlt : received.Frame,
            Param1 = received.Param1,
            Param2 = received.Param2,
            Param3 = received.Param3,
            Param4 = received.Param4,
            X = received.X,
            Y = received.Y,
            Z = received.Z,
        };

        // A place in floats is too coarse: what needs one comes as COMMAND_INT.
        return !isLong || received.Command is not (MavCmd.DoReposition or MavCmd.PreflightRebootShutdown)
            ? Execute(command)
            : received.Command == MavCmd.DoReposition
                ? MavResult.Unsupported
                : Reboot(received.Param1, received.Param6);
    }

    /// <summary>SET_MODE (11), the older way; the acknowledgement names its message id, as ArduPilot's does.</summary>
    public void Handle(in SetMode message, Sender sender) => sink.Send(new CommandAck
    {
        Command = (MavCmd)SetMode.MavlinkId,
        Result = SetModeTo(message.BaseMode, message.CustomMode),
        TargetSystem = sender.SystemId,
        TargetComponent = sender.ComponentId,
    });

    private MavResult Execute(in CommandInt command)
    {
        switch (command.Command)
        {
            case MavCmd.ComponentArmDisarm: return ArmOrDisarm(command.Param1, command.Param2);
            case MavCmd.DoSetMode:
                return SetModeTo((MavModeFlag)WholeNumber(command.Param1), WholeNumber(command.Param2));
            case MavCmd.DoFenceEnable: return EnableFence(command.Param1);
            case MavCmd.NavTakeoff: return Result(controller.TryTakeOff(command.Z));
            case MavCmd.NavReturnToLaunch: return Result(controller.TrySetMode((uint)CopterMode.Rtl));
            case MavCmd.NavLand: return Result(controller.TrySetMode((uint)CopterMode.Land));
            case MavCmd.NavLoiterUnlim: return Result(controller.TrySetMode((uint)CopterMode.Loiter));
            case MavCmd.MissionStart: return Result(controller.TryStartMission());
            case MavCmd.DoSetMissionCurrent: return SetCurrent(WholeNumber(command.Param1));
            case MavCmd.DoReposition: return Reposition(command);
            case MavCmd.DoChangeSpeed: return ChangeSpeed(command.Param1, command.Param2);
            case MavCmd.ConditionYaw: return Turn(command.Param1, command.Param3, command.Param4);
            case MavCmd.DoPauseContinue: return PauseOrGoOn(command.Param1);
            case MavCmd.DoMountControl: return PointCamera(command.Param1, command.Param3, flags: 0);
            default: return ExecuteRequest(command);
        }
    }

    private MavResult SetCurrent(uint sequence)
    {
        if (sequence > int.MaxValue || controller.Auto.Mission?.TrySetCurrent((int)sequence) != true)
            return MavResult.Failed;
        controller.JumpTo((int)sequence);
        return MavResult.Accepted;
    }

    private MavResult ExecuteRequest(in CommandInt command)
    {
        int messageId = (int)WholeNumber(command.Param1);
        switch (command.Command)
        {
            case MavCmd.SetMessageInterval:
                return SetInterval(messageId, command.Param2);
            case MavCmd.GetMessageInterval:
                sink.Send(
                    new MessageInterval { MessageId = (ushort)messageId, IntervalUs = streams.IntervalOf(messageId) });
                return MavResult.Accepted;
            case MavCmd.RequestMessage:
                return messageId == AvailableModes.MavlinkId
                    ? Result(telemetry.SendModes((int)WholeNumber(command.Param2)))
                    : RequestMessage(messageId);
            case MavCmd.GetHomePosition:
                return RequestMessage(HomePosition.MavlinkId);
            case MavCmd.RequestAutopilotCapabilities:
                return RequestMessage(AutopilotVersion.MavlinkId);
            default:
                return MavResult.Unsupported;
        }
    }

    private MavResult SetInterval(int messageId, float microseconds)
    {
        if (!TelemetrySender.IsKnown(messageId))
            say(MavSeverity.Info, FormattableString.Invariant($"No ap_message for mavlink id ({messageId})"));
        return streams.Set(messageId, microseconds, controller.Situation.Time);
    }

    private MavResult EnableFence(float enables)
    {
        if (!enables.Equals(0f) && !enables.Equals(1f))
            return MavResult.Failed;
        controller.Situation.Parameters.Fence.Enable.Set(enables);
        return MavResult.Accepted;
    }

    // 1: the autopilot, 3: and stays in its boot loader, which is not simulated; armed only by force.
    private MavResult Reboot(float what, float magic)
    {
        if (!what.Equals(1f) && !what.Equals(3f))
            return MavResult.Unsupported;
        if (controller.IsArmed && !magic.Equals(ForceRebootMagic))
            return MavResult.Failed;
        WantsReboot = true;
        return MavResult.Accepted;
    }

    private MavResult RequestMessage(int messageId)
    {
        if (!TelemetrySender.IsKnown(messageId))
            return MavResult.Failed;
        telemetry.Send(messageId);
        return MavResult.Accepted;
    }

    private MavResult ArmOrDisarm(float arms, float magic)
    {
        if (arms.Equals(1f))
            return Result(controller.TryArm(isForced: magic.Equals(ForceMagic) || magic.Equals(ForceArmMagic)));
        return arms.Equals(0f)
            ? Result(controller.TryDisarm(isForced: magic.Equals(ForceMagic)))
            : MavResult.Unsupported;
    }

    private MavResult SetModeTo(MavModeFlag baseMode, uint customMode)
        => (baseMode & MavModeFlag.CustomModeEnabled) == 0
            ? MavResult.Denied
            : Result(controller.TrySetMode(customMode));

    private MavResult Reposition(in CommandInt command)
    {
        bool changesMode = ((int)WholeNumber(command.Param2) & (int)MavDoRepositionFlags.ChangeMode) != 0;
        if (!controller.IsGuided && !changesMode)
            return MavResult.Denied;
        if (!targets.TryReadPlace(command.Frame, command.X, command.Y, command.Z, out NedVector place))
            return MavResult.Denied;
        if (!controller.Failsafes.Fence.Accepts(place)
            || (!controller.IsGuided && !controller.TrySetMode((uint)CopterMode.Guided)))
        {
            return MavResult.Failed;
        }

        controller.Guided.GoTo(controller.Situation, place, HeadingTarget.None);
        return MavResult.Accepted;
    }

    // Only a mode that flies by itself has a speed; a change of the mode brings the speed of the parameters back.
    private MavResult ChangeSpeed(float kind, float speed)
    {
        if (!(speed > 0))
            return MavResult.Denied;
        if (!controller.IsGuided)
            return MavResult.Failed;
        switch ((SpeedType)WholeNumber(kind))
        {
            case SpeedType.Airspeed or SpeedType.Groundspeed:
                controller.Guided.SetSpeed(speed);
                return MavResult.Accepted;
            case SpeedType.ClimbSpeed: controller.Guided.SetSpeedUp(speed); return MavResult.Accepted;
            case SpeedType.DescentSpeed: controller.Guided.SetSpeedDown(speed); return MavResult.Accepted;
            default: return MavResult.Denied;
        }
    }

    private MavResult Turn(float degrees, float direction, float isRelative)
    {
        if (!controller.IsGuided || !(degrees >= 0 && degrees <= 360)
            || (!isRelative.Equals(0f) && !isRelative.Equals(1f)))
            return MavResult.Failed;
        double angle = degrees * NedMath.RadiansPerDegree;
        bool turnsBack = direction < 0;
        controller.Guided.Turn(isRelative.Equals(0f) ? angle : controller.Situation.Yaw + (turnsBack ? -angle : angle));
        return MavResult.Accepted;
    }

    private MavResult PauseOrGoOn(float goesOn)
    {
        if (!controller.IsGuided || controller.Situation.IsLanded)
            return MavResult.Failed;
        if (goesOn.Equals(0f))
            controller.Guided.Pause(controller.Situation);
        else if (!goesOn.Equals(1f))
            return MavResult.Denied;
        else
            controller.Guided.GoOn(controller.Situation);
        return MavResult.Accepted;
    }

    private MavResult PointCamera(float pitchDegrees, float yawDegrees, float flags)
    {
        if (float.IsNaN(pitchDegrees) || float.IsNaN(yawDegrees) || Math.Abs(pitchDegrees) > 360
            || Math.Abs(yawDegrees) > 360)
            return MavResult.Denied;
        gimbal.Point(
            pitchDegrees * NedMath.RadiansPerDegree, yawDegrees * NedMath.RadiansPerDegree,
            Gimbal.IsYawFromNorth(flags));
        return MavResult.Accepted;
    }

    private static MavResult Result(bool isDone) => isDone ? MavResult.Accepted : MavResult.Failed;

    // What is no number, or does not fit, becomes the largest one, which is no mode and no id.
    private static uint WholeNumber(float value) => value >= 0 && value < MaxNumber ? (uint)value : uint.MaxValue;
}
