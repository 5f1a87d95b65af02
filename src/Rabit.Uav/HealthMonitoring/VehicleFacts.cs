using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Input of the rules for the vehicle.</summary>
internal readonly struct VehicleFacts(
    in VehicleState state, in RateRequestCounts requests, TimeSpan now, bool isReplayOver,
    double gustMetresPerSecond = double.NaN, in EnergyStatus energy = default)
{
    // Reported once a second; an older estimate is out of date.
    private static readonly TimeSpan MaxWindAge = TimeSpan.FromSeconds(5);

    public VehicleState State { get; } = state;

    /// <summary>How the autopilot answered our first commands, which ask for message rates.</summary>
    public RateRequestCounts Requests { get; } = requests;

    public TimeSpan HeartbeatAge { get; } = now - state.LastHeartbeatTime;

    /// <summary>Whether all links are recorded logs that have been played: then silence is expected.</summary>
    public bool IsReplayOver { get; } = isReplayOver;

    /// <summary>The strongest wind of the last seconds, metres per second; NaN where it is not known.</summary>
    public double GustMetresPerSecond { get; } = gustMetresPerSecond;

    /// <summary>What is left and what the way home takes, by Mission Control.</summary>
    public EnergyStatus Energy { get; } = energy;

    /// <summary>Whether that is known.</summary>
    public bool IsEnergyKnown => Energy.IsKnown;

    /// <summary>Whether the autopilot reports an estimate of the wind.</summary>
    public bool IsWindKnown { get; } = now - state.WindTime <= MaxWindAge && !double.IsNaN(state.WindMetresPerSecond);
}
