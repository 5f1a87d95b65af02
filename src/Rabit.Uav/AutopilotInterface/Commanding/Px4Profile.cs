using System;
using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// PX4: places by set-points in OFFBOARD, altitudes of a take-off above mean sea level, modes by main and sub number.
/// </summary>
/// <remarks>
/// Not by DO_REPOSITION in AUTO.LOITER: that mode is also the pilot's Hold, which PX4 accepts there and does nothing,
/// and the flag that changes the mode, without which PX4 denies the command, undoes a takeover. In OFFBOARD the
/// pilot's AUTO.LOITER and POSCTL stand although set-points go on (docs/decisions/0017).
/// </remarks>
internal sealed class Px4Profile : VehicleProfile
{
    // An altitude at which PX4 ends a take-off: within NAV_MC_ALT_RAD, 0.8 m by default.
    private const double TakeOffToleranceMetres = 1;

    // As far below as the position reported last may be: 0.8 m, half a second at MPC_TKO_SPEED (1.5 m/s), and noise.
    private const double SettlingMetres = 2.5;

    private static readonly TimeSpan MaxPositionAge = TimeSpan.FromSeconds(1);

    public static Px4Profile Instance { get; } = new();

    /// <summary>Also what it waits in, from arming on.</summary>
    public override uint CommandedMode => Px4Modes.Loiter;

    public override uint ReturnMode => Px4Modes.Return;

    public override uint LandMode => Px4Modes.Land;

    private protected override bool GivesGimbalsToOne => true;

    public override bool FollowsByItself(uint mode, in VehicleState vehicle, double takeOffHeightMetres)
    {
        uint next = vehicle.CustomMode;
        return mode switch
        {
            // Below its height AUTO.LOITER is the pilot's Hold.
            Px4Modes.Takeoff => next == Px4Modes.Loiter
                && vehicle.HeightAboveHomeMetres >= takeOffHeightMetres - TakeOffToleranceMetres,

            // PX4 returns and lands in AUTO.RTL alone; in the air another mode is the pilot's or a failsafe's.
            Px4Modes.Land or Px4Modes.Return => next is Px4Modes.Loiter or Px4Modes.Land
                && vehicle.LandedState == MavLandedState.OnGround,
            _ => false,
        };
    }

    // After a gap in the link the height is an old one. In AUTO.LOITER it goes on to the height of the take-off; a
    // pilot's Hold stays below.
    public override bool MayFollowByItself(uint mode, in VehicleState vehicle, double takeOffHeightMetres)
        => mode == Px4Modes.Takeoff && vehicle.CustomMode == Px4Modes.Loiter
            && (vehicle.HeightAboveHomeMetres >= takeOffHeightMetres - SettlingMetres
                || vehicle.LastHeartbeatTime - vehicle.PositionTime > MaxPositionAge);

    public override uint? ModeOf(MavType vehicle, string name) => Px4Modes.NumberOf(name);

    private protected override (float Mode, float SubMode) ModeParameters(uint mode)
        => ((byte)(mode >> 16), (byte)(mode >> 24));

    private protected override string? PlanFlight(
        in VehicleCommand command, in CommandContext context, List<CommandStep> steps)
    {
        switch (command.Kind)
        {
            case VehicleCommandKind.Velocity:
                return "velocities are not supported on PX4 yet";
            case VehicleCommandKind.Hold:
                steps.Add(SetMode(Px4Modes.Loiter));
                return null;
            case VehicleCommandKind.TakeOff or VehicleCommandKind.GoTo when !context.IsPositionFresh:
                return "where the vehicle is is not known, and so not how high home lies above the sea";
            case VehicleCommandKind.TakeOff:
                steps.Add(TakeOff(context.HomeAltitudeAmslMetres + command.HeightAboveHomeMetres));
                return null;
            case VehicleCommandKind.GoTo:
                return PlanGoTo(context, steps);
            default:
                return $"{command.Kind} is not known";
        }
    }

    // Set-points that come again end a failsafe: not by us. From any mode but those of our take-off and hold,
    // AUTO.LOITER is taken and shown first.
    private string? PlanGoTo(in CommandContext context, List<CommandStep> steps)
    {
        VehicleState vehicle = context.Vehicle;
        if (!context.IsStreaming)
        {
            if (vehicle.SystemStatus is MavState.Critical or MavState.Emergency)
                return $"the autopilot reports {vehicle.SystemStatus}: no set-point is sent in a failsafe";
            if (vehicle.CustomMode is not (Px4Modes.Loiter or Px4Modes.Takeoff))
                steps.Add(SetMode(Px4Modes.Loiter));
            steps.Add(new CommandStep { StartsStream = true });
            steps.Add(SetMode(Px4Modes.Offboard));
        }

        steps.Add(new CommandStep { SetsTarget = true });
        return null;
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
        NeedsReport = true,
    };
}
