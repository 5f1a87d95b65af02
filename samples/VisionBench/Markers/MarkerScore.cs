using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Vision;

namespace VisionBench;

/// <summary>The markers that were read in one picture against its truth.</summary>
internal sealed class MarkerScore
{
    private readonly List<MarkerMatch> _matches = [];

    /// <param name="picture">With its truth.</param>
    /// <param name="width">Its columns.</param>
    /// <param name="height">Its rows.</param>
    /// <param name="read">What was read in it.</param>
    public MarkerScore(MarkerPicture picture, int width, int height, IEnumerable<DetectedMarker> read)
    {
        (Picture, Width, Height) = (picture, width, height);
        List<DetectedMarker> left = [.. read];
        foreach (ListedMarker marker in picture.Markers)
        {
            int at = left.FindIndex(m => marker.Is(m));
            if (marker.Counts)
                _matches.Add(new MarkerMatch(marker, at < 0 ? null : left[at]));
            if (at >= 0)
                left.RemoveAt(at);
        }

        Wrong = [.. left.Where(m => !picture.MayHave(m))];
    }

    public MarkerPicture Picture { get; }

    public int Width { get; }

    public int Height { get; }

    /// <summary>One for each that counts.</summary>
    public IReadOnlyList<MarkerMatch> Matches => _matches;

    /// <summary>Ids that were read where that marker is not.</summary>
    public IReadOnlyList<DetectedMarker> Wrong { get; }

    public static string Describe(in DetectedMarker wrong) => FormattableString.Invariant(
        $"marker {wrong.Family} {wrong.Id} at {wrong.Corners.Centre.X:0.0}, {wrong.Corners.Centre.Y:0.0}");
}
