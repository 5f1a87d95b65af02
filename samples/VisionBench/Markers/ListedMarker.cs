using System;
using System.Collections.Immutable;
using System.Linq;
using System.Text.Json;
using Rabit.Vision;

namespace VisionBench;

/// <summary>A marker that is in a picture, as the truth file has it. Lengths in pixels.</summary>
internal sealed class ListedMarker
{
    // As the reference counts them.
    private const double MinVisible = 0.98;

    private ListedMarker(JsonElement json, ImmutableArray<PicturePoint> corners, bool counts)
    {
        Family = FamilyOf(json.TextOf("family"));
        Id = json.WholeOf("id");
        (Corners, Counts) = (corners, counts);
    }

    public MarkerFamily Family { get; }

    public int Id { get; }

    /// <summary>Those of the black square, clockwise from the top left of the upright marker.</summary>
    public ImmutableArray<PicturePoint> Corners { get; }

    /// <summary>Whether it is to be found; others may be found or not.</summary>
    public bool Counts { get; }

    public double Left => Corners.Min(c => c.X);

    public double Top => Corners.Min(c => c.Y);

    public double Right => Corners.Max(c => c.X);

    public double Bottom => Corners.Max(c => c.Y);

    /// <param name="json">Family, id and corners.</param>
    /// <param name="fractionVisible">How much of it can be seen.</param>
    public static ListedMarker Of(JsonElement json, double fractionVisible)
        => Of(json, json.FieldOf("corners_px"), fractionVisible);

    /// <param name="json">Family and id.</param>
    /// <param name="corners">Its corners.</param>
    /// <param name="fractionVisible">How much of it can be seen.</param>
    public static ListedMarker Of(JsonElement json, JsonElement corners, double fractionVisible = 1)
        => new(json, PointsOf(corners, 0), fractionVisible >= MinVisible);

    /// <summary>
    /// A tag of a photo, as libapriltag found it: centres of pixels are halves; left bottom, right bottom, right top,
    /// left top of a tag that stands on its head against OpenCV's.
    /// </summary>
    public static ListedMarker OfPhoto(JsonElement tag)
    {
        ImmutableArray<PicturePoint> corners = PointsOf(tag.FieldOf("corners_lb_rb_rt_lt"), -0.5);
        return new ListedMarker(
            tag, ImmutableArray.Create(corners[1], corners[0], corners[3], corners[2]),
            tag.FlagOf("agreed"));
    }

    /// <summary>Whether it is this one, and there.</summary>
    public bool Is(in DetectedMarker marker)
    {
        PicturePoint centre = marker.Corners.Centre;
        double x = centre.X - Corners.Average(c => c.X);
        double y = centre.Y - Corners.Average(c => c.Y);
        double acrossX = Corners[0].X - Corners[2].X;
        double acrossY = Corners[0].Y - Corners[2].Y;
        return marker.Family == Family && marker.Id == Id
            && Math.Sqrt((x * x) + (y * y)) < 0.3 * Math.Sqrt((acrossX * acrossX) + (acrossY * acrossY));
    }

    public string Describe() => FormattableString.Invariant(
        $"marker {Family} {Id}, {Math.Sqrt((Right - Left) * (Bottom - Top)):0.0} px at {Corners.Average(c => c.X):0.0}, {Corners.Average(c => c.Y):0.0}");

    private static MarkerFamily FamilyOf(string name) => name switch
    {
        "aruco_4x4_50" => MarkerFamily.ArUco4x4,
        "apriltag_36h11" or "tag36h11" => MarkerFamily.AprilTag36h11,
        _ => throw new FormatException($"\"{name}\" is no family of markers that is read"),
    };

    private static ImmutableArray<PicturePoint> PointsOf(JsonElement corners, double shift)
        => corners.ValueKind == JsonValueKind.Array && corners.GetArrayLength() == 4
            ? TruthJson.Each(corners, "corners", (c, _) => TruthJson.Numbers(c, 2) is { } point
                ? new PicturePoint(point[0] + shift, point[1] + shift)
                : throw new FormatException("it must be a list of 2 numbers")).ToImmutableArray()
            : throw new FormatException("a marker has other than four corners");
}
