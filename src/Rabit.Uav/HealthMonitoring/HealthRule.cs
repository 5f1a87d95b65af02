using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>One row of the table: the reason, how bad it is, what to do about it in flight, when it holds, and its figure.</summary>
internal sealed class HealthRule<T>(
    HealthReasons reason, HealthLevel level, HealthAdvice advice, HealthCondition<T> condition, HealthFigure<T> figure, bool isAdvisedAfterwards = false)
    where T : struct
{
    public HealthReasons Reason { get; } = reason;

    public HealthLevel Level { get; } = level;

    public HealthAdvice Advice { get; } = advice;

    /// <summary>Whether the advice makes sense only once the reason is gone.</summary>
    public bool IsAdvisedAfterwards { get; } = isAdvisedAfterwards;

    public HealthCondition<T> Condition { get; } = condition;

    public HealthFigure<T> Figure { get; } = figure;
}
