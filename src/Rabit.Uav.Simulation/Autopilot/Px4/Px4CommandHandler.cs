using System;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// COMMAND_LONG, COMMAND_INT and SET_MODE: executes them, with the result codes of PX4 1.14. What is refused is
/// TEMPORARILY_REJECTED without a reason.
/// </summary>
internal sealed class Px4CommandHandler(
    Px4Controller controller, Px4SetPointReader places, Px4RequestHandler requests, Gimbal gimbal, WorldFrame frame)
{
    private const float ForceMagic = 21196;
    private const double DegE7 = 1e7;

    // Who may point the gimbal; no one at the start.
    private MavlinkAddress _gimbalOwner;

    /// <summary>Executes a command that came over a link, and says with what result.</summary>
    public MavResult Execute(in MavlinkCommandRequest request, int link)
    {
        MavlinkCommand received = request.Command;
        // In COMMAND_LONG places are in degrees, heights above sea level.
        bool isLong = received.Forms == MavlinkCommandForms.LongOnly;
        if (received.Command == MavCmd.DoGimbalManagerPitchyaw)
        {
            return request.Source == _gimbalOwner
                ? PointCamera(received.Param1, received.Param2, isLong ? received.Param5 : received.X)
                : MavResult.Denied;
        }

        if (received.Command == MavCmd.DoGimbalManagerConfigure)
            return GiveGimbal(received.Param1, received.Param2, request.Source);
        return Execute(
            new CommandInt
            {
                Command = received.Command,
                Frame = isLong ? MavFrame.Global : received.Frame,
                Param1 = received.Param1,
                Param2 = received.Param2,
                Param3 = received.Param3,
                Param4 = received.Param4,
                X = isLong ? ToDegE7(received.Param5) : received.X,
                Y = isLong ? ToDegE7(received.Param6) : received.Y,
                Z = received.Z,
            },
            link);
    }

    /// <summary>SET_MODE (11), the older way: it is not acknowledged.</summary>
    public void Handle(in SetMode message)
        => SetModeTo((float)message.BaseMode, (byte)(message.CustomMode >> 16), (byte)(message.CustomMode >> 24));

    private MavResult Execute(in CommandInt command, int link)
    {
        switch (command.Command)
        {
            case MavCmd.ComponentArmDisarm: return ArmOrDisarm(command.Param1, command.Param2);
            case MavCmd.DoSetMode: return SetModeTo(command.Param1, command.Param2, command.Param3);
            case MavCmd.NavTakeoff: return TakeOff(command);
            case MavCmd.NavReturnToLaunch: return Result(controller.TrySetMode(Px4Mode.Rtl));
            case MavCmd.NavLand: return Result(controller.TrySetMode(Px4Mode.Land));
            case MavCmd.MissionStart: return StartMission(command.Param1);
            case MavCmd.DoReposition: return Reposition(command);
            case MavCmd.DoOrbit: return Orbit(command);
            case MavCmd.DoChangeSpeed: return ChangeSpeed(command.Param2);
            case MavCmd.DoMountControl: return PointCamera(command.Param1, command.Param3, flags: 0);
            default: return requests.Execute(command, link);
        }
    }

    private MavResult ArmOrDisarm(float arms, float magic)
    {
        bool isForced = magic.Equals(ForceMagic);
        if (arms.Equals(1f))
            return Result(controller.TryArm(isForced));
        return arms.Equals(0f) ? Result(controller.TryDisarm(isForced)) : MavResult.Denied;
    }

    // It arms as well.
    private MavResult StartMission(float first)
    {
        if (!controller.Mission.HasMission || !(first >= -1 && first < controller.Mission.Items!.Count))
            return MavResult.Denied;
        if (first > 0)
            controller.Mission.JumpTo(controller.Situation, (int)first);
        return Result(controller.TrySetMode(Px4Mode.Mission) && controller.TryArm(isForced: false));
    }

    // An unknown mode is accepted, and nothing happens.
    private MavResult SetModeTo(float baseMode, float main, float sub)
    {
        bool isCustom = ((int)baseMode & (int)MavModeFlag.CustomModeEnabled) != 0;
        if (!isCustom || !(main >= 0 && main <= byte.MaxValue) || !(sub >= 0 && sub <= byte.MaxValue))
            return MavResult.Accepted;
        uint mode = ((uint)main << 16) | ((uint)sub << 24);
        if (Px4ModeNames.IsFlown(mode) && (Px4Mode)mode != Px4Mode.Orbit)
            return Result(controller.TrySetMode((Px4Mode)mode));
        return Px4ModeNames.IsKnownButNotFlown(mode) ? MavResult.TemporarilyRejected : MavResult.Accepted;
    }

    // The height is above sea level; a place that is NaN is here.
    private MavResult TakeOff(in CommandInt command)
    {
        NedVector here = controller.Situation.Position;
        if (!controller.Situation.HasPosition)
            return MavResult.TemporarilyRejected;
        double down = float.IsNaN(command.Z)
            ? here.Down - controller.Situation.Parameters.TakeoffHeight.Value
            : frame.Origin.AltitudeAmslMetres - command.Z;
        bool isHere = command.X == int.MinValue || command.Y == int.MinValue || (command.X == 0 && command.Y == 0);
        NedVector place = here;
        if (!isHere && !places.TryReadPlace(MavFrame.Global, command.X, command.Y, 0, out place))
            return MavResult.Denied;
        controller.Takeoff.Commanded = new NedVector(place.North, place.East, down);
        return Result(controller.TrySetMode(Px4Mode.Takeoff));
    }

    // Without the flag the commander does not know the command, but AUTO.LOITER flies there all the same. The height is
    // above sea level in every frame.
    private MavResult Reposition(in CommandInt command)
    {
        bool changesMode = ((int)command.Param2 & (int)MavDoRepositionFlags.ChangeMode) != 0;
        if (!TryReadTarget(command, out NedVector place))
            return MavResult.Denied;
        if (changesMode && !controller.TrySetMode(Px4Mode.Loiter))
            return MavResult.TemporarilyRejected;
        if (controller.Mode == Px4Mode.Loiter)
        {
            controller.Hold.GoTo(place, command.Param4);
            if (command.Param1 > 0)
                controller.Situation.CommandedSpeed = command.Param1;
        }

        return changesMode ? MavResult.Accepted : MavResult.Unsupported;
    }

    private MavResult Orbit(in CommandInt command)
    {
        if (!TryReadTarget(command, out NedVector middle) || !(Math.Abs(command.Param1) >= 1))
            return MavResult.Denied;
        double speed = command.Param2 > 0 ? command.Param2 : 1;
        controller.Orbit.Circle(middle, command.Param1, speed);
        return Result(controller.TrySetMode(Px4Mode.Orbit));
    }

    private bool TryReadTarget(in CommandInt command, out NedVector place)
    {
        NedVector here = controller.Situation.Position;
        double aboveSea = float.IsNaN(command.Z) ? frame.Origin.AltitudeAmslMetres - here.Down : command.Z;
        if (command.X != int.MinValue && command.Y != int.MinValue)
            return places.TryReadPlace(MavFrame.Global, command.X, command.Y, aboveSea, out place);
        place = new NedVector(here.North, here.East, frame.Origin.AltitudeAmslMetres - aboveSea);
        return true;
    }

    // Only AUTO modes have a speed; in OFFBOARD it is accepted and has no effect.
    private MavResult ChangeSpeed(float speed)
    {
        if (speed > 0 && Px4ModeNames.IsAuto(controller.Mode))
            controller.Situation.CommandedSpeed = speed;
        return MavResult.Accepted;
    }

    // Of the special values -1 leaves it as it is, -2 is the autopilot itself, -3 gives it back.
    private MavResult GiveGimbal(float systemId, float componentId, MavlinkAddress source)
    {
        _gimbalOwner = new MavlinkAddress(
            Owner(systemId, _gimbalOwner.SystemId, source.SystemId),
            Owner(componentId, _gimbalOwner.ComponentId, source.ComponentId));
        return MavResult.Accepted;
    }

    private static byte Owner(float id, byte now, byte source) => Math.Round(id) switch
    {
        >= 0 and < 256 => (byte)Math.Round(id),
        -2 => AutopilotAddress.ComponentId,
        -3 when now == source => 0,
        _ => now,
    };

    private MavResult PointCamera(float pitchDegrees, float yawDegrees, float flags)
    {
        if (!(Math.Abs(pitchDegrees) <= 360) || !(Math.Abs(yawDegrees) <= 360))
            return MavResult.Denied;
        gimbal.Point(
            pitchDegrees * NedMath.RadiansPerDegree, yawDegrees * NedMath.RadiansPerDegree,
            Gimbal.IsYawFromNorth(flags));
        return MavResult.Accepted;
    }

    private static MavResult Result(bool isDone) => isDone ? MavResult.Accepted : MavResult.TemporarilyRejected;

    private static int ToDegE7(float degrees)
        => float.IsNaN(degrees) || Math.Abs(degrees) > 200 ? int.MinValue : (int)Math.Round(degrees * DegE7);
}
