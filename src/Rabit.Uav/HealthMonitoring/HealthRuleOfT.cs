using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>One row of the table with its conditions on the facts that it judges.</summary>
internal sealed class HealthRule<T>(HealthReasons reason, HealthLevel level, HealthAdvice advice)
    : HealthRule(reason, level, advice)
    where T : struct
{
    /// <summary>What makes it a finding, once it held for <see cref="HealthRule.Dwell"/>.</summary>
    public HealthCondition<T> When { get; init; } = static (in T _, HealthOptions _) => false;

    /// <summary>
    /// What ends the finding, once it held for <see cref="HealthRule.ClearDwell"/>; null where it is that
    /// <see cref="When"/> no longer holds.
    /// </summary>
    public HealthCondition<T>? Until { get; init; }

    /// <summary>The figure that is reported with the finding.</summary>
    public HealthFigure<T> Figure { get; init; } = static (in T _) => 0;
}
