using System.Collections.Generic;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Preflight;

/// <summary>Ground speed of the autopilot's own return, by its parameters.</summary>
internal static class ReturnSpeed
{
    private const string Px4Cruise = "MPC_XY_CRUISE";
    private const string ArdupilotReturn = "RTL_SPEED";
    private const string ArdupilotWaypoint = "WPNAV_SPEED";

    // PX4 flies its AUTO modes a little below it: 3.6 to 4.7 m/s of 5 in a recorded return.
    private const double PartOfPx4Cruise = 0.9;

    // Where nothing is known: MPC_XY_CRUISE of PX4, half of ArduPilot's WPNAV_SPEED. Slow is the safe side: against a
    // head wind it takes more.
    private const double Unknown = 5;

    /// <summary>The parameters by which it is known.</summary>
    public static IReadOnlyList<string> ParametersOf(MavAutopilot autopilot) => autopilot switch
    {
        MavAutopilot.Px4 => [Px4Cruise],
        MavAutopilot.Ardupilotmega => [ArdupilotReturn, ArdupilotWaypoint],
        _ => [],
    };

    /// <summary>Metres per second.</summary>
    public static double Of(AutopilotParameters parameters, MavAutopilot autopilot) => autopilot == MavAutopilot.Px4
        ? Known(parameters, Px4Cruise, PartOfPx4Cruise) ?? Unknown
        : Known(parameters, ArdupilotReturn, 0.01) ?? Known(parameters, ArdupilotWaypoint, 0.01) ?? Unknown;

    // RTL_SPEED 0: as WPNAV_SPEED.
    private static double? Known(AutopilotParameters parameters, string name, double scale)
        => parameters.TryGet(name, out AutopilotParameter parameter) && parameter.Value > 0
            ? parameter.Value * scale
            : null;
}
