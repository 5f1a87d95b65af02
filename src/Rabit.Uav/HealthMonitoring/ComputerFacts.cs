using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Input of the rules for the companion computer: unknown where the last look is too old.</summary>
internal readonly struct ComputerFacts(in ComputerStatus status, TimeSpan now)
{
    // Once a second; later a disk hangs, and holds up the look.
    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(5);

    public ComputerStatus Status { get; } = now - status.Time <= MaxAge ? status : ComputerStatus.Unknown;

    /// <summary>What is so now of the supply and the clock.</summary>
    public ComputerThrottling Throttling
        => (Status.Throttling ?? ComputerThrottling.None) & ComputerThrottling.Now;
}
