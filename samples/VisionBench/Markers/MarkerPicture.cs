using System;
using System.Collections.Immutable;
using Rabit.Vision;

namespace VisionBench;

/// <summary>A picture and the markers that are in it.</summary>
internal sealed class MarkerPicture(
    string name, string filePath, int index, ImmutableArray<ListedMarker> markers,
    Func<DetectedMarker, bool> mayHave)
{
    public string Name { get; } = name;

    public string FilePath { get; } = filePath;

    /// <summary>From 1, in the order of the set.</summary>
    public int Index { get; } = index;

    public ImmutableArray<ListedMarker> Markers { get; } = markers;

    /// <summary>Whether a reading that is not listed may be right.</summary>
    public bool MayHave(DetectedMarker marker) => mayHave(marker);
}
