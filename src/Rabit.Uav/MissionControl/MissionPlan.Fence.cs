using System.Collections.Generic;
using System.Collections.Immutable;
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

    // From the area to the autopilot's fence.
    private double AutopilotFenceMarginMetres
    {
        get
        {
            double speed = SpeedMetresPerSecond;
            return FenceMarginMetres + (speed * speed / (2 * DecelerationMetresPerSecondSquared))
                + (ReactionSeconds * speed) + PositionErrorMetres;
        }
    }

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
        return FenceOutline.Of(plan.Area, default, AutopilotFenceMarginMetres).Corners
            .Select(c => plan.Frame.ToGeodetic(new NedPosition(c.North, c.East, 0))).ToArray();
    }

    /// <summary>
    /// The area that can be searched inside a fence of the autopilot, so that Mission Control acts first; of several
    /// parts the largest.
    /// </summary>
    /// <param name="fence">Corners in order.</param>
    /// <returns>The corners; none where there is no such area.</returns>
    internal ImmutableArray<GeodeticPosition> AreaWithin(IReadOnlyList<GeodeticPosition> fence)
    {
        LocalNedFrame frame = LocalNedFrame.IgnoringGeoid(fence[0]);
        var outline = new PlanePolygon(
            fence.Select(c => frame.ToNed(c)).Select(p => new PlanePoint(p.North, p.East)));
        if (outline.FindCrossing() is not null)
            return [];
        return FenceOutline.Inside(outline, AutopilotFenceMarginMetres) is { } area
            ? [.. area.Corners.Select(c => frame.ToGeodetic(new NedPosition(c.North, c.East, 0)))]
            : [];
    }
}
