using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>One thing that is wrong: reason, severity, subject, and the figure that is reported with it.</summary>
internal readonly struct HealthFinding(
    HealthReasons reason,
    HealthLevel level,
    string? subject,
    long figure,
    HealthAdvice advice = HealthAdvice.None,
    bool isAdvisedAfterwards = false)
    : IEquatable<HealthFinding>
{
    public HealthReasons Reason { get; } = reason;

    public HealthLevel Level { get; } = level;

    /// <summary>A manager or a link; null where it is the vehicle.</summary>
    public string? Subject { get; } = subject;

    /// <summary>
    /// Its meaning depends on the reason; chosen such that it stays constant while nothing of interest changes.
    /// </summary>
    public long Figure { get; } = figure;

    /// <summary>What Mission Control is advised to do in flight.</summary>
    public HealthAdvice Advice { get; } = advice;

    /// <summary>Whether the advice can be followed only once the reason is over.</summary>
    public bool IsAdvisedAfterwards { get; } = isAdvisedAfterwards;

    public bool Equals(HealthFinding other)
        => Reason == other.Reason && Level == other.Level && Figure == other.Figure && Advice == other.Advice
            && string.Equals(Subject, other.Subject, StringComparison.Ordinal);

    public override bool Equals(object? obj) => obj is HealthFinding other && Equals(other);

    public override int GetHashCode() => unchecked((Reason.GetHashCode() * 397) ^ Figure.GetHashCode());
}
