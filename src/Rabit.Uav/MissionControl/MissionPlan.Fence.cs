using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;

namespace Rabit.Uav.MissionControl;

// The fence that the autopilot is given.
public sealed partial class MissionPlan
{
    // Decelerations of a multirotor in its guided modes are 2.5 m/s2 and more (ArduPilot's WPNAV_ACCEL).
    private const double DecelerationMetresPerSecondSquared = 2.5;

    // From outside our fence to the command that turns it back: a tick of Mission Control and the link, with a margin.
    private const double ReactionSeconds = 2;
    private const double PositionErrorMetres = 5;

    /// <summary>
    /// The fence to be uploaded to the autopilot (<c>AutopilotSetupOptions.Fence</c>): the mission's own geofence and a
    /// reserve in which the vehicle stops from the mission's speed, so that Mission Control acts first.
    /// </summary>
    /// <param name="home">Where the vehicle stands; its altitude is that of the ground.</param>
    /// <returns>The corners in order; none where the mission cannot be flown from there.</returns>
    public IReadOnlyList<GeodeticPosition> AutopilotFence(GeodeticPosition home)
    {
        // With a lane of no meaning: the fence does not depend on them.
        if (FlightPlan.Create(this, home, out _, [new LaneSegment(default, default)]) is not { } plan)
            return [];
        double speed = SpeedMetresPerSecond;
        double reserve = (speed * speed / (2 * DecelerationMetresPerSecondSquared)) + (ReactionSeconds * speed)
            + PositionErrorMetres;
        return FenceOutline.Of(plan.Area, default, FenceMarginMetres + reserve).Corners
            .Select(c => plan.Frame.ToGeodetic(new NedPosition(c.North, c.East, 0))).ToArray();
    }
}
