using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// ArduPilot's Plane: places in GUIDED, without the flag that changes the mode: in another mode it then refuses them.
/// </summary>
internal sealed class ArdupilotPlaneProfile() : FixedWingProfile(MavAutopilot.Ardupilotmega)
{
    public static ArdupilotPlaneProfile Instance { get; } = new();

    public override uint ReturnMode => (uint)PlaneMode.Rtl;

    public override uint? ModeOf(MavType vehicle, string name) => ArdupilotModes.NumberOf(vehicle, name);

    private protected override (float Mode, float SubMode) ModeParameters(uint mode) => (mode, 0);

    // Speeds stay its own, above the stall. Its parameter 4 is the direction of the circle, where older versions take
    // not-a-number for counter-clockwise.
    private protected override CommandStep PlanPlace(in VehicleCommand command, in CommandContext context)
    {
        CommandStep step = Reposition(
            MavFrame.GlobalRelativeAltInt, command.Latitude.Radians, command.Longitude.Radians,
            command.HeightAboveHomeMetres, Plain);
        step.Request = step.Request with { Param3 = (float)command.LoiterRadiusMetres, Param4 = 0 };
        return step;
    }
}
