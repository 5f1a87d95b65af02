namespace Rabit.Uav.MissionControl;

/// <summary>How each confirmed target is revisited, that is, observed once more from overhead. Immutable.</summary>
public sealed class RevisitPlan
{
    /// <summary>Whether targets are revisited.</summary>
    public bool IsEnabled { get; init; } = true;

    /// <summary>Height of the revisit above home, metres; null for that of the search.</summary>
    public double? HeightMetres { get; init; }

    /// <summary>
    /// Distance from the target at which the pass over it begins, across the lanes, metres; 0 to fly straight to it.
    /// </summary>
    public double RadiusMetres { get; init; } = 10;
}
