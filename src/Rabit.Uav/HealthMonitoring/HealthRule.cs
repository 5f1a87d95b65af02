using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// One row of the table: the reason, its severity, the advice in flight, the condition, and the figure.
/// </summary>
internal sealed class HealthRule<T>(
    HealthReasons reason,
    HealthLevel level,
    HealthAdvice advice,
    HealthCondition<T> condition,
    HealthFigure<T> figure,
    bool isAdvisedAfterwards = false)
    where T : struct
{
    public HealthReasons Reason { get; } = reason;

    public HealthLevel Level { get; } = level;

    public HealthAdvice Advice { get; } = advice;

    /// <summary>Whether the advice can be followed only once the reason is over.</summary>
    public bool IsAdvisedAfterwards { get; } = isAdvisedAfterwards;

    public HealthCondition<T> Condition { get; } = condition;

    public HealthFigure<T> Figure { get; } = figure;
}
