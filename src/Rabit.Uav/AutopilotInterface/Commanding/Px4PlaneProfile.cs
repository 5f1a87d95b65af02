using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// PX4's fixed wings: places in AUTO.LOITER, with the flag that changes the mode, without which PX4 denies them; so
/// only on the arrival of a report that shows AUTO.LOITER.
/// </summary>
internal sealed class Px4PlaneProfile() : FixedWingProfile(MavAutopilot.Px4)
{
    // MAV_DO_REPOSITION_FLAGS_CHANGE_MODE.
    private const float ChangesMode = 1;

    public static Px4PlaneProfile Instance { get; } = new();

    public override uint ReturnMode => Px4Modes.Return;

    private protected override bool GivesGimbalsToOne => true;

    public override uint? ModeOf(MavType vehicle, string name) => Px4Modes.NumberOf(name);

    private protected override (float Mode, float SubMode) ModeParameters(uint mode)
        => ((byte)(mode >> 16), (byte)(mode >> 24));

    // As recorded of the multirotor: the altitude is above the sea, whatever the frame says.
    private protected override CommandStep PlanPlace(in VehicleCommand command, in CommandContext context)
    {
        CommandStep step = Reposition(
            MavFrame.Global, command.Latitude.Radians, command.Longitude.Radians,
            context.HomeAltitudeAmslMetres + command.HeightAboveHomeMetres, Plain, ChangesMode);
        step.Request = step.Request with { Param3 = (float)command.LoiterRadiusMetres };
        step.Mode = CommandedMode;
        step.NeedsReport = true;
        return step;
    }
}
