using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// A polygon that the vehicle may not leave, or may not enter, as items of the mission protocol (MAVLink guide,
/// "Geofence": a NAV_FENCE_POLYGON_VERTEX_INCLUSION, or EXCLUSION, for each corner, with the number of corners in
/// parameter 1).
/// </summary>
internal static class FencePolygon
{
    private const double DegreesE7PerRadian = 180 / Math.PI * 1e7;

    public static IReadOnlyList<FenceItem> ToItems(
        IReadOnlyList<GeodeticPosition> corners, MavCmd command = MavCmd.NavFencePolygonVertexInclusion)
        => corners.Select(c => new FenceItem(
            command, MavFrame.Global, corners.Count, 0, 0, 0,
            DegreesE7(c.Latitude), DegreesE7(c.Longitude), 0)).ToArray();

    private static int DegreesE7(Angle angle) => (int)Math.Round(angle.Radians * DegreesE7PerRadian);
}
