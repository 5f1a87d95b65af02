namespace Rabit.Uav.MissionControl;

/// <summary>How a new target is looked at again. Immutable.</summary>
public sealed class RevisitPlan
{
    /// <summary>Whether it is at all.</summary>
    public bool IsEnabled { get; init; } = true;

    /// <summary>Height above home, metres; null for that of the search.</summary>
    public double? HeightMetres { get; init; }

    /// <summary>From how far away it is flown over, across the lanes, metres; 0 for straight there.</summary>
    public double RadiusMetres { get; init; } = 10;
}
