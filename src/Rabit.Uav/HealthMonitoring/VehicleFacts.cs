using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>What the rules judge the vehicle by.</summary>
internal readonly struct VehicleFacts(in VehicleState state, TimeSpan now, bool isReplayOver, TimeSpan? windHighFor = null)
{
    public VehicleState State { get; } = state;

    public TimeSpan HeartbeatAge { get; } = now - state.LastHeartbeatTime;

    /// <summary>Whether all links are recorded logs that have been played: then silence is what is to be expected.</summary>
    public bool IsReplayOver { get; } = isReplayOver;

    /// <summary>For how long the wind has been stronger than it may be; null while it is not, or is not known.</summary>
    public TimeSpan? WindHighFor { get; } = windHighFor;
}
