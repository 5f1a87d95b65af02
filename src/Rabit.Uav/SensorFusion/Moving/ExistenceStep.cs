using System;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>What may have become of a target in a time. A plain value.</summary>
internal readonly struct ExistenceStep(TrackerSettings settings, double seconds)
{
    /// <summary>How likely it is still there.</summary>
    public double Survival { get; } = Math.Exp(-settings.DeathsPerSecond * seconds);

    /// <summary>How likely one that was in sight is out of it now.</summary>
    public double Hides { get; } = 1 - Math.Exp(-settings.HidesPerSecond * seconds);

    /// <summary>How likely one that was out of sight is back in it.</summary>
    public double Appears { get; } = 1 - Math.Exp(-settings.AppearsPerSecond * seconds);
}
