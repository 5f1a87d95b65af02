using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// PX4: places in AUTO.LOITER by DO_REPOSITION, altitudes above mean sea level, modes by main and sub number.
/// </summary>
/// <remarks>
/// PX4 takes DO_REPOSITION only with the flag that changes the mode. A pilot who takes over while one is on its way may
/// have to do it again. Velocities need OFFBOARD, whose stream must run before the mode is taken: not done yet.
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

    private protected override (float Mode, float SubMode) ModeParameters(uint mode)
        => ((byte)(mode >> 16), (byte)(mode >> 24));

    private protected override string? PlanFlight(
        in VehicleCommand command, in CommandContext context, List<CommandStep> steps)
    {
        if (command.Kind == VehicleCommandKind.Velocity)
            return "velocities are not supported on PX4 yet";
        if (!context.IsPositionFresh)
            return "where the vehicle is is not known, and so not how high home lies above the sea";
        VehicleState vehicle = context.Vehicle;
        double homeAmsl = vehicle.Position.AltitudeAmslMetres - vehicle.HeightAboveHomeMetres;
        switch (command.Kind)
        {
            case VehicleCommandKind.TakeOff:
                steps.Add(TakeOff(homeAmsl + command.HeightAboveHomeMetres));
                return null;
            case VehicleCommandKind.GoTo:
                EnsureCommandedMode(vehicle, steps);
                steps.Add(
                    Reposition(
                        command.Latitude.Radians, command.Longitude.Radians, homeAmsl + command.HeightAboveHomeMetres,
                        command));
                return null;
            case VehicleCommandKind.Hold:
                // The mode alone would let it fly on to the last place.
                EnsureCommandedMode(vehicle, steps);
                GeodeticPosition here = StoppingPoint(vehicle);
                steps.Add(Reposition(here.Latitude.Radians, here.Longitude.Radians, here.AltitudeAmslMetres, Plain));
                return null;
            default:
                return $"{command.Kind} is not known";
        }
    }

    // Not a number: from here, with the heading that it has.
    private static CommandStep TakeOff(double altitudeAmslMetres) => new()
    {
        Request = new MavlinkCommand
        {
            Command = MavCmd.NavTakeoff,
            Param4 = float.NaN,
            Param5 = float.NaN,
            Param6 = float.NaN,
            Z = (float)altitudeAmslMetres,
        },
        Mode = Px4Modes.Takeoff,
        IsDoneInTheAir = true,
    };

    private CommandStep Reposition(
        double latitudeRadians, double longitudeRadians, double altitudeAmslMetres, in VehicleCommand command)
    {
        CommandStep step = Reposition(
            MavFrame.Global, latitudeRadians, longitudeRadians, altitudeAmslMetres, command, ChangesMode);
        step.Mode = CommandedMode;
        return step;
    }
}
