using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Vision;

namespace VisionBench;

/// <summary>A marker that counts, and what was found of it.</summary>
internal sealed class MarkerMatch(ListedMarker marker, DetectedMarker? found)
{
    public ListedMarker Marker { get; } = marker;

    /// <summary>Null for a miss.</summary>
    public DetectedMarker? Found { get; } = found;

    /// <summary>How far each corner is off, pixels; none of a miss.</summary>
    public IEnumerable<double> CornerErrors => Found is { } found
        ? Enumerable.Range(0, 4).Select(i => Distance(found.Corners[i], Marker.Corners[i]))
        : [];

    private static double Distance(PicturePoint a, PicturePoint b)
        => Math.Sqrt(((a.X - b.X) * (a.X - b.X)) + ((a.Y - b.Y) * (a.Y - b.Y)));
}
