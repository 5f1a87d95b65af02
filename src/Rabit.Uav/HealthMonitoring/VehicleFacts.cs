using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Input of the rules for the vehicle.</summary>
internal readonly struct VehicleFacts(
    in VehicleState state, in RateRequestCounts requests, TimeSpan now, bool isReplayOver, TimeSpan? windHighFor = null)
{
    public VehicleState State { get; } = state;

    /// <summary>How the autopilot answered our first commands, which ask for message rates.</summary>
    public RateRequestCounts Requests { get; } = requests;

    public TimeSpan HeartbeatAge { get; } = now - state.LastHeartbeatTime;

    /// <summary>Whether all links are recorded logs that have been played: then silence is expected.</summary>
    public bool IsReplayOver { get; } = isReplayOver;

    /// <summary>For how long the wind has been above its limit; null while it is not, or is unknown.</summary>
    public TimeSpan? WindHighFor { get; } = windHighFor;
}
