using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Ground speed of the autopilot's own return, by its parameters.</summary>
internal static class ReturnSpeed
{
    // PX4 flies its AUTO modes a little below it: 3.6 to 4.7 m/s of 5 in a recorded return.
    private const double PartOfPx4Cruise = 0.9;

    // Where nothing is known: MPC_XY_CRUISE of PX4, half of ArduPilot's WPNAV_SPEED. Against a head wind slow costs more.
    private const double Unknown = 5;

    public static double Of(AutopilotParameters parameters, MavAutopilot autopilot, EnergyOptions options)
    {
        if (options.ReturnSpeedMetresPerSecond is { } set)
            return set;
        if (autopilot == MavAutopilot.Px4)
            return Known(parameters, "MPC_XY_CRUISE", PartOfPx4Cruise) ?? Unknown;
        return Known(parameters, "RTL_SPEED", 0.01) ?? Known(parameters, "WPNAV_SPEED", 0.01) ?? Unknown;
    }

    // RTL_SPEED 0: as WPNAV_SPEED.
    private static double? Known(AutopilotParameters parameters, string name, double scale)
        => parameters.TryGet(name, out AutopilotParameter parameter) && parameter.Value > 0
            ? parameter.Value * scale
            : null;
}
