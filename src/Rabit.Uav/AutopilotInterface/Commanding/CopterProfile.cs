using System;
using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>ArduPilot's Copter: targets in GUIDED, take-off height above home, a place by DO_REPOSITION.</summary>
/// <remarks>
/// A place goes out as DO_REPOSITION in a COMMAND_INT and not as SET_POSITION_TARGET_GLOBAL_INT: that one has no
/// acknowledgement and is silently ignored outside GUIDED, so that "accepted" would be a guess. It never carries the
/// flag that changes the mode: were the pilot to take over while it is on its way, it must be refused and not win. A
/// position target stays in force until the next one, so that nothing is repeated. Speed and heading follow the place,
/// since Copter starts with its own when it begins to fly to places; each has an acknowledgement of its own.
/// </remarks>
internal sealed class CopterProfile : VehicleProfile
{
    // SPEED_TYPE_GROUNDSPEED, and "no change" of the throttle (MAV_CMD_DO_CHANGE_SPEED).
    private const double GroundSpeed = 1;
    private const double NoThrottle = -1;
    private const double FullTurnDegrees = 360;

    public static CopterProfile Instance { get; } = new();

    public override uint CommandedMode => (uint)CopterMode.Guided;

    public override uint ReturnMode => (uint)CopterMode.Rtl;

    public override uint LandMode => (uint)CopterMode.Land;

    public override bool FollowsByItself(uint mode, in VehicleState vehicle, double takeOffHeightMetres)
        => mode == ReturnMode && vehicle.CustomMode == LandMode;

    public override uint? ModeOf(MavType vehicle, string name) => ArdupilotModes.NumberOf(vehicle, name);

    private protected override (float Mode, float SubMode) ModeParameters(uint mode) => (mode, 0);

    private protected override string? PlanFlight(
        in VehicleCommand command, in CommandContext context, List<CommandStep> steps)
    {
        VehicleState vehicle = context.Vehicle;
        if (command.Kind == VehicleCommandKind.Hold && !context.IsPositionFresh)
        {
            steps.Add(SetMode((uint)CopterMode.Brake));
            return null;
        }

        EnsureCommandedMode(vehicle, steps);
        switch (command.Kind)
        {
            case VehicleCommandKind.TakeOff:
                steps.Add(new CommandStep
                {
                    Request = new MavlinkCommand
                    {
                        Command = MavCmd.NavTakeoff,
                        Z = (float)command.HeightAboveHomeMetres
                    },
                    IsDoneInTheAir = true,
                    NeedsReport = true,
                });
                return null;
            case VehicleCommandKind.GoTo:
                PlanGoTo(command, context, steps);
                return null;
            case VehicleCommandKind.Velocity:
                steps.Add(new CommandStep { StartsVelocity = true });
                return null;
            case VehicleCommandKind.Hold:
                GeodeticPosition here = StoppingPoint(vehicle);
                steps.Add(
                    Reposition(
                        MavFrame.GlobalRelativeAltInt, here.Latitude.Radians, here.Longitude.Radians,
                        vehicle.HeightAboveHomeMetres, Plain));
                return null;
            default:
                return $"{command.Kind} is not known";
        }
    }

    private static void PlanGoTo(in VehicleCommand command, in CommandContext context, List<CommandStep> steps)
    {
        double speed = command.SpeedMetresPerSecond;
        Angle yaw = command.Yaw;
        steps.Add(
            Reposition(
                MavFrame.GlobalRelativeAltInt, command.Latitude.Radians, command.Longitude.Radians,
                command.HeightAboveHomeMetres, command));
        if (!double.IsNaN(speed) && !speed.Equals(context.LastSpeedMetresPerSecond))
            steps.Add(Long(MavCmd.DoChangeSpeed, GroundSpeed, speed, NoThrottle));
        if (yaw.IsFinite)
            steps.Add(Long(MavCmd.ConditionYaw, Heading(yaw)));
    }

    // Rounded to what a float holds below, so that 360 never comes out.
    private static double Heading(Angle yaw)
    {
        double degrees = Math.Round(yaw.Degrees, 3) % FullTurnDegrees;
        return degrees < 0 ? degrees + FullTurnDegrees : degrees;
    }
}
