using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// One row of the table, for whatever it judges: the reason, its severity, the advice in flight, and its words.
/// </summary>
internal abstract class HealthRule(HealthReasons reason, HealthLevel level, HealthAdvice advice)
{
    public HealthReasons Reason { get; } = reason;

    public HealthLevel Level { get; } = level;

    public HealthAdvice Advice { get; } = advice;

    /// <summary>Whether the advice can be followed only once the reason is over.</summary>
    public bool IsAdvisedAfterwards { get; init; }

    /// <summary>
    /// Findings of the same subject that say less than this one, and are left out: rows that stand before it.
    /// </summary>
    public HealthReasons Supersedes { get; init; }

    /// <summary>How long the condition holds before it is a finding.</summary>
    public HealthDuration Dwell { get; init; } = static _ => TimeSpan.Zero;

    /// <summary>How long the opposite holds before the finding ends.</summary>
    public HealthDuration ClearDwell { get; init; } = static _ => TimeSpan.Zero;

    /// <summary>The finding for the operator; null where another row of the same reason has it.</summary>
    public HealthText.Words? Text { get; init; }

    /// <summary>The condition in words, with its thresholds.</summary>
    public Func<HealthOptions, string> Condition { get; init; } = static _ => string.Empty;

    /// <summary>What ends the finding, in words: its hysteresis.</summary>
    public Func<HealthOptions, string> End { get; init; } = static _ => string.Empty;

    /// <summary>Why the thresholds and the advice are as they are.</summary>
    public string Why { get; init; } = string.Empty;
}
