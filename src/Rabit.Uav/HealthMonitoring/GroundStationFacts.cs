using System;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Input of the rules for the ground station.</summary>
internal readonly struct GroundStationFacts(TimeSpan? lastTime, TimeSpan now, bool isReplayOver)
{
    /// <summary>When its last heartbeat was received over any link; null where none ever was.</summary>
    public TimeSpan? LastTime { get; } = lastTime;

    /// <summary>Since its last heartbeat; zero where there was none: what was never there is not lost.</summary>
    public TimeSpan Silence { get; } = lastTime is { } time && !isReplayOver && now > time ? now - time : TimeSpan.Zero;
}
