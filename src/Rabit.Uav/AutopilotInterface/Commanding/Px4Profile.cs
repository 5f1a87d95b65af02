using System.Collections.Generic;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Geometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>PX4: places in AUTO.LOITER by DO_REPOSITION, altitudes above mean sea level, modes by main and sub number.</summary>
/// <remarks>
/// PX4 takes DO_REPOSITION only with the flag that changes the mode. A pilot who takes over while one is on its way may have to do it again.
/// Velocities need OFFBOARD, whose stream must run before the mode is taken: not done yet.
/// </remarks>
internal sealed class Px4Profile : VehicleProfile
{
    private const float ChangesMode = (float)MavDoRepositionFlags.ChangeMode;

    public static Px4Profile Instance { get; } = new();

    public override uint CommandedMode => Px4Modes.Loiter;

    public override uint ReturnMode => Px4Modes.Return;

    public override uint LandMode => Px4Modes.Land;

    public override bool FollowsByItself(uint mode, uint next) => mode switch
    {
        Px4Modes.Takeoff or Px4Modes.Land => next == Px4Modes.Loiter,
        Px4Modes.Return => next is Px4Modes.Loiter or Px4Modes.Land,
        _ => false,
    };

    public override uint? ModeOf(MavType vehicle, string name) => Px4Modes.NumberOf(name);

    public override CommandStep SetMode(uint mode)
    {
        CommandStep step = Long(MavCmd.DoSetMode, ByCustomMode, (byte)(mode >> 16), (byte)(mode >> 24));
        step.Mode = mode;
        step.IsModeAwaited = true;
        return step;
    }

    public override string? Plan(in VehicleCommand command, in CommandContext context, List<CommandStep> steps)
    {
        VehicleState vehicle = context.Vehicle;
        switch (command.Kind)
        {
            case VehicleCommandKind.Arm:
                steps.Add(SetMode(CommandedMode));
                steps.Add(Arm(true));
                return null;
            case VehicleCommandKind.Disarm:
                steps.Add(Arm(false));
                return null;
            case VehicleCommandKind.SetMode:
                return PlanMode(command.Mode!, vehicle, steps);
            case VehicleCommandKind.Return:
                steps.Add(SetMode(ReturnMode));
                return null;
            case VehicleCommandKind.Land:
                steps.Add(SetMode(LandMode));
                return null;
            case VehicleCommandKind.PointCamera:
                steps.Add(PointCamera(command));
                return null;
            case VehicleCommandKind.Velocity:
                return "velocities are not supported on PX4 yet";
            default:
                return context.IsPositionFresh
                    ? PlanFlight(command, vehicle, steps)
                    : "where the vehicle is is not known, and so not how high home lies above the sea";
        }
    }

    private string? PlanFlight(in VehicleCommand command, in VehicleState vehicle, List<CommandStep> steps)
    {
        double homeAmsl = vehicle.Position.AltitudeAmslMetres - vehicle.HeightAboveHomeMetres;
        switch (command.Kind)
        {
            case VehicleCommandKind.TakeOff:
                steps.Add(TakeOff(homeAmsl + command.HeightAboveHomeMetres));
                return null;
            case VehicleCommandKind.GoTo:
                EnsureCommandedMode(vehicle, steps);
                var place = GeodeticPosition.FromRadians(command.LatitudeRadians, command.LongitudeRadians, homeAmsl + command.HeightAboveHomeMetres);
                steps.Add(Reposition(place, command.SpeedMetresPerSecond, command.YawRadians));
                return null;
            case VehicleCommandKind.Hold:
                // The mode alone would let it fly on to the last place.
                EnsureCommandedMode(vehicle, steps);
                steps.Add(Reposition(StoppingPoint(vehicle), double.NaN, double.NaN));
                return null;
            default:
                return $"{command.Kind} is not known";
        }
    }

    // Not a number: from here, with the heading that it has.
    private static CommandStep TakeOff(double altitudeAmslMetres) => new()
    {
        Request = new MavlinkRequest
        {
            Command = MavCmd.NavTakeoff,
            Param4 = float.NaN,
            Param5 = float.NaN,
            Param6 = float.NaN,
            Param7 = (float)altitudeAmslMetres,
        },
        Mode = Px4Modes.Takeoff,
        IsDoneInTheAir = true,
    };

    private CommandStep Reposition(in GeodeticPosition place, double speed, double yaw) => new()
    {
        Request = new MavlinkRequest
        {
            Command = MavCmd.DoReposition,
            Frame = MavFrame.Global,
            Param1 = double.IsNaN(speed) ? -1 : (float)speed,
            Param2 = ChangesMode,
            Param4 = (float)yaw,
            LatitudeDegE7 = DegE7(place.LatitudeRadians),
            LongitudeDegE7 = DegE7(place.LongitudeRadians),
            Param7 = (float)place.AltitudeAmslMetres,
        },
        Mode = CommandedMode,
    };
}
