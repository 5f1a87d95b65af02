using System;
using System.Collections.Generic;

namespace Rabit.Uav.MissionControl;

/// <summary>How a fixed wing flies a mission.</summary>
public sealed class FixedWingOptions
{
    /// <summary>
    /// Radius of the circles that the aircraft flies, metres, 20 to 400: NAV_LOITER_RAD of PX4, WP_LOITER_RAD of
    /// ArduPilot, or more, and what it can fly at its speed. It comes to each lane by such a circle.
    /// </summary>
    /// <value>The default is 80 m, that of PX4.</value>
    public double LoiterRadiusMetres { get; set; } = 80;

    internal FixedWingOptions Copy() => (FixedWingOptions)MemberwiseClone();

    internal IEnumerable<string> FindFaults()
    {
        if (!(LoiterRadiusMetres >= 20 && LoiterRadiusMetres <= 400))
        {
            yield return FormattableString.Invariant(
                $"{nameof(LoiterRadiusMetres)} is {LoiterRadiusMetres}; it must be 20 to 400");
        }
    }
}
