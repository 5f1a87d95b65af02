using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>A confirmed target in a progress file. Immutable.</summary>
public sealed class MissionProgressTarget
{
    /// <summary>The id that its track had; the next flight counts from one again.</summary>
    public int TrackId { get; init; }

    /// <summary>What it is.</summary>
    public TargetClassName Class { get; init; }

    /// <summary>Where it is.</summary>
    public GeodeticPosition Position { get; init; }

    /// <summary>Half the long axis of the ellipse that holds the truth with 95 %, metres.</summary>
    public double HalfMajorAxis95Metres { get; init; }

    /// <summary>How many reports the track was made of.</summary>
    public int Reports { get; init; }

    /// <summary>Whether the revisit of it is over.</summary>
    public bool IsRevisited { get; init; }
}
