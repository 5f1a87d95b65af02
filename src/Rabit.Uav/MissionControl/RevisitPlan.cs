using System;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// How each confirmed target is revisited, that is, observed once more from overhead; one that moves is followed.
/// Immutable.
/// </summary>
public sealed class RevisitPlan
{
    /// <summary>Makes one with the default values.</summary>
    public RevisitPlan()
    {
    }

    internal RevisitPlan(RevisitPlan other)
        => (IsEnabled, HeightMetres, RadiusMetres, MaxWayFraction, FollowTime, FollowSpeedMetresPerSecond)
            = (other.IsEnabled, other.HeightMetres, other.RadiusMetres, other.MaxWayFraction, other.FollowTime,
                other.FollowSpeedMetresPerSecond);

    /// <summary>Whether targets are revisited.</summary>
    public bool IsEnabled { get; init; } = true;

    /// <summary>Height of the revisit, above what that of the search is, metres; null for the same.</summary>
    public double? HeightMetres { get; init; }

    /// <summary>
    /// Distance from the target at which the pass over it begins and turns back, across the lanes, metres; 0 to fly
    /// straight to it. Less, or in another direction, where the pass would leave the fence.
    /// </summary>
    public double RadiusMetres { get; init; } = 10;

    /// <summary>
    /// How much way all revisits together may take beside that of the search, as a fraction of the way along the lanes
    /// and between them. Their time is limited too: to what the search would take for that way, and half a minute for
    /// each revisit that was made. Targets beyond that are not revisited.
    /// </summary>
    public double MaxWayFraction { get; init; } = 1.0 / 3;

    /// <summary>
    /// For how long a target of a class that moves is kept in view; zero to revisit it as one that stands.
    /// </summary>
    public TimeSpan FollowTime { get; init; } = TimeSpan.FromSeconds(20);

    /// <summary>
    /// How fast the vehicle flies to keep a target in view, metres per second; null, or less than the speed of the
    /// search, for that.
    /// </summary>
    public double? FollowSpeedMetresPerSecond { get; init; }
}
