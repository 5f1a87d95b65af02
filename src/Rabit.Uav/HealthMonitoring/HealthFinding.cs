using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>One thing that is wrong: what, how bad, with whom, and the figure that people want to know.</summary>
internal readonly struct HealthFinding(
    HealthReasons reason, HealthLevel level, string? subject, long figure, HealthAdvice advice = HealthAdvice.None, bool isAdvisedAfterwards = false)
    : IEquatable<HealthFinding>
{
    public HealthReasons Reason { get; } = reason;

    public HealthLevel Level { get; } = level;

    /// <summary>A manager or a link; null where it is the vehicle.</summary>
    public string? Subject { get; } = subject;

    /// <summary>Its meaning depends on the reason; chosen such that it is still while nothing of interest changes.</summary>
    public long Figure { get; } = figure;

    /// <summary>What is to be done about it in flight.</summary>
    public HealthAdvice Advice { get; } = advice;

    /// <summary>Whether that can be done only once it is over.</summary>
    public bool IsAdvisedAfterwards { get; } = isAdvisedAfterwards;

    public bool Equals(HealthFinding other)
        => Reason == other.Reason && Level == other.Level && Figure == other.Figure && Advice == other.Advice && string.Equals(Subject, other.Subject, StringComparison.Ordinal);

    public override bool Equals(object? obj) => obj is HealthFinding other && Equals(other);

    public override int GetHashCode() => unchecked(((int)Reason * 397) ^ Figure.GetHashCode());
}
