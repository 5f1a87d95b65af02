using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>One row of the table: the reason, how bad it is, when it holds, and its figure.</summary>
internal sealed class HealthRule<T>(HealthReasons reason, HealthLevel level, HealthCondition<T> condition, HealthFigure<T> figure)
    where T : struct
{
    public HealthReasons Reason { get; } = reason;

    public HealthLevel Level { get; } = level;

    public HealthCondition<T> Condition { get; } = condition;

    public HealthFigure<T> Figure { get; } = figure;
}
