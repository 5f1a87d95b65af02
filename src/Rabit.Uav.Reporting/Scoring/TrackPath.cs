using System.Collections.Generic;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Where the track of a target that moves was while it was seen: a point each second, for one hour. Immutable.
/// </summary>
/// <param name="trackId">The track.</param>
/// <param name="points">Where it was, oldest first.</param>
public sealed class TrackPath(int trackId, IReadOnlyList<TrackPoint> points)
{
    /// <summary>The track.</summary>
    public int TrackId { get; } = trackId;

    /// <summary>Where it was, oldest first.</summary>
    public IReadOnlyList<TrackPoint> Points { get; } = points;
}
