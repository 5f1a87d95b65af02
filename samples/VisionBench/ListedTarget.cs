using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Vision;

namespace VisionBench;

/// <summary>One target of a picture, as the truth file has it. Lengths in pixels.</summary>
internal sealed class ListedTarget
{
    public ListedTarget(JsonElement json)
    {
        Kind = json.TextOf("class");
        Colour = json.TextOf("color");
        Shape = json.TextOf("shape");
        Size = json.NumberOf("size_px");
        FractionVisible = json.NumberOf("fraction_visible");
        IsWhole = !json.FlagOf("occluded") && !json.FlagOf("truncated");
        IsSeen = json.FieldOf("visible_centroid_px").ValueKind != JsonValueKind.Null;
        double[] centre = IsSeen ? json.NumbersOf("visible_centroid_px", 2) : [double.NaN, double.NaN];
        (X, Y) = (centre[0], centre[1]);
        if (json.TryGetProperty("marker", out JsonElement marker))
            Marker = ListedMarker.Of(marker, FractionVisible);
        double[] box = json.NumbersOf("bbox_px", 4);
        (Left, Top, Right, Bottom) = (box[0], box[1], box[2], box[3]);
    }

    /// <summary>A panel of a photo, in full sight.</summary>
    public ListedTarget(string colour, PicturePoint centre, IReadOnlyCollection<PicturePoint> corners, double size)
    {
        (Kind, Colour, Shape, Size, FractionVisible) = ("panel", colour, "square", size, 1);
        (IsWhole, IsSeen) = (true, true);
        (X, Y) = (centre.X, centre.Y);
        (Left, Top) = (corners.Min(c => c.X), corners.Min(c => c.Y));
        (Right, Bottom) = (corners.Max(c => c.X), corners.Max(c => c.Y));
    }

    public string Kind { get; }

    /// <summary>Which marker it is; null for another target, and where the file does not say it.</summary>
    public ListedMarker? Marker { get; }

    public string Colour { get; }

    public string Shape { get; }

    /// <summary>Of the class that a detector should report; null for one that it is not asked for.</summary>
    public string? Class => Kind switch
    {
        "panel" => "panel-" + Colour,
        "vehicle" => "vehicle-" + Colour,
        "person" => "person",
        _ => null,
    };

    /// <summary>Square root of its area.</summary>
    public double Size { get; }

    public double FractionVisible { get; }

    /// <summary>Neither hidden in part nor cut by the edge of the picture.</summary>
    public bool IsWhole { get; }

    public bool IsSeen { get; }

    /// <summary>Centroid of what can be seen of it, column.</summary>
    public double X { get; }

    /// <summary>Centroid of what can be seen of it, row.</summary>
    public double Y { get; }

    public double Left { get; }

    public double Top { get; }

    public double Right { get; }

    public double Bottom { get; }

    /// <summary>Whether it counts for recall; detections of others are ignored.</summary>
    public bool Counts => Class is not null && IsSeen && FractionVisible >= 0.5 && Size >= 4;

    /// <summary>Whether a centre is near enough to be of this target.</summary>
    public bool Matches(double x, double y)
    {
        double reach = Math.Max(3, 0.5 * Size);
        return IsSeen && ((x - X) * (x - X)) + ((y - Y) * (y - Y)) <= reach * reach;
    }

    public string Describe() => FormattableString.Invariant(
        $"{Class} {Shape} {Size:0.0} px at {X:0.0}, {Y:0.0}, {FractionVisible:0.00} visible");

    /// <summary>Whether a place lies on it or on its margin.</summary>
    public bool Covers(double x, double y)
        => x >= Left - 3 && x <= Right + 3 && y >= Top - 3 && y <= Bottom + 3;
}
