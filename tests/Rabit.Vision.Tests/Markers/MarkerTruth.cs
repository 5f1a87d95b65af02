using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;

namespace Rabit.Vision.Tests.Markers;

/// <summary>A marker that is in a picture.</summary>
internal sealed record MarkerTruth(MarkerFamily Family, int Id, PicturePoint[] Corners, bool Counts)
{
    public static MarkerFamily FamilyOf(string name)
        => name == "aruco_4x4_50" ? MarkerFamily.ArUco4x4 : MarkerFamily.AprilTag36h11;

    public static PicturePoint[] PointsOf(JsonElement corners, double shift = 0)
        => [.. corners.EnumerateArray()
            .Select(c => new PicturePoint(c[0].GetDouble() + shift, c[1].GetDouble() + shift))];

    public static IEnumerable<MarkerTruth> AllOf(JsonElement markers) => markers.EnumerateArray().Select(m =>
        new MarkerTruth(
            FamilyOf(m.GetProperty("family").GetString()!), m.GetProperty("id").GetInt32(),
            PointsOf(m.GetProperty("corners_px")), m.GetProperty("fraction_visible").GetDouble() >= 0.98));

    public bool Is(DetectedMarker marker)
    {
        PicturePoint centre = marker.Corners.Centre;
        double x = centre.X - Corners.Average(c => c.X);
        double y = centre.Y - Corners.Average(c => c.Y);
        double acrossX = Corners[0].X - Corners[2].X;
        double acrossY = Corners[0].Y - Corners[2].Y;
        return marker.Family == Family && marker.Id == Id
            && Math.Sqrt((x * x) + (y * y)) < 0.3 * Math.Sqrt((acrossX * acrossX) + (acrossY * acrossY));
    }
}
