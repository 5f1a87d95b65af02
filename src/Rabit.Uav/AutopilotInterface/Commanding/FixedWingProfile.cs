using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Fixed wings: a place is one DO_REPOSITION, in the mode in which the pilot gave the vehicle over; a hold is a circle
/// where it is. It never takes off, lands or takes that mode from another one but our own return.
/// </summary>
/// <remarks>
/// The target stays in force until the next one. It counts as acknowledged when POSITION_TARGET_GLOBAL_INT shows it,
/// so that a lost answer does not send it twice (recorded of ArduPlane: the place to the digit, within 0.05 s).
/// </remarks>
internal abstract class FixedWingProfile(MavAutopilot autopilot) : VehicleProfile
{
    /// <summary>Why it is not commanded without the option.</summary>
    public const string NotAllowed = "a FixedWing is commanded with AutopilotOptions.MayCommandFixedWing only "
        + "(UavConsole: --fixed-wing): its pilot takes off, gives it over and lands, it circles where it holds, and on "
        + "PX4 a pilot's Hold cannot be seen";

    // Half a metre: a float of the wire or a rounding is less.
    private const int MaxShiftDegE7 = 45;

    private readonly (uint Mode, string Name) _given = FixedWings.GivenMode(autopilot)!.Value;

    public override uint CommandedMode => _given.Mode;

    // It is never landed by us: the base refuses the command before.
    public override uint LandMode => ReturnMode;

    /// <summary>Whether a report shows the target of a step.</summary>
    public static bool IsTarget(in CommandStep step, in PositionTargetGlobalInt target)
        => step.Request.Command == MavCmd.DoReposition
            && Math.Abs((long)target.LatInt - step.Request.X) <= MaxShiftDegE7
            && Math.Abs((long)target.LonInt - step.Request.Y) <= MaxShiftDegE7;

    // RTL circles over home; what follows is the pilot's.
    public override bool FollowsByItself(uint mode, in VehicleState vehicle, double takeOffHeightMetres) => false;

    public override string? Plan(in VehicleCommand command, in CommandContext context, List<CommandStep> steps)
        => command.Kind switch
        {
            VehicleCommandKind.Arm or VehicleCommandKind.Disarm or VehicleCommandKind.TakeOff
                or VehicleCommandKind.Land => $"{command.Kind}: a fixed wing is taken off and landed by its pilot",
            VehicleCommandKind.SetMode => "SetMode: the modes of a fixed wing are its pilot's",
            VehicleCommandKind.Velocity => "Velocity: a fixed wing takes places only",
            _ => base.Plan(command, context, steps),
        };

    private protected override string? PlanFlight(
        in VehicleCommand command, in CommandContext context, List<CommandStep> steps)
    {
        VehicleState vehicle = context.Vehicle;
        bool isGiven = vehicle.CustomMode == CommandedMode;
        if (!isGiven && command.Kind == VehicleCommandKind.Hold && vehicle.CustomMode == ReturnMode)
        {
            // The mode begins with a circle where it is.
            steps.Add(SetMode(CommandedMode));
            return null;
        }

        if (!isGiven)
            return $"the vehicle is in {vehicle.Mode}: its pilot has not given it over, in {_given.Name}";
        if (!context.IsPositionFresh)
            return "where the vehicle is is not known";
        CommandStep step = PlanPlace(command.Kind == VehicleCommandKind.GoTo ? command : Here(vehicle), context);
        step.OnlyInMode = CommandedMode;
        steps.Add(step);
        return null;
    }

    /// <summary>The DO_REPOSITION to a place.</summary>
    private protected abstract CommandStep PlanPlace(in VehicleCommand command, in CommandContext context);

    private static VehicleCommand Here(in VehicleState vehicle) => new()
    {
        Kind = VehicleCommandKind.Hold,
        Latitude = vehicle.Position.Latitude,
        Longitude = vehicle.Position.Longitude,
        HeightAboveHomeMetres = vehicle.HeightAboveHomeMetres,
    };
}
