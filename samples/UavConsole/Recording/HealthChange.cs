using System;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>Health Monitoring found or asked for something else. Immutable.</summary>
internal sealed class HealthChange(TimeSpan time, HealthReport report)
{
    /// <summary>By the clock of the run.</summary>
    public TimeSpan Time { get; } = time;

    public HealthReport Report { get; } = report;
}
