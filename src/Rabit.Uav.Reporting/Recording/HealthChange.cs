using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>A change of level, reasons or advice of Health Monitoring. Immutable.</summary>
/// <param name="time">By the clock of the run.</param>
/// <param name="report">The new report.</param>
public sealed class HealthChange(TimeSpan time, HealthReport report)
{
    /// <summary>By the clock of the run.</summary>
    public TimeSpan Time { get; } = time;

    /// <summary>The new report.</summary>
    public HealthReport Report { get; } = report;
}
