using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>What a command is planned by.</summary>
internal readonly struct CommandContext(in VehicleState vehicle, TimeSpan now, double lastSpeedMetresPerSecond)
{
    private static readonly TimeSpan FreshFor = TimeSpan.FromSeconds(3);

    public VehicleState Vehicle { get; } = vehicle;

    /// <summary>The speed of the last command to go to a place; NaN where something else came in between.</summary>
    public double LastSpeedMetresPerSecond { get; } = lastSpeedMetresPerSecond;

    /// <summary>Whether the position is known and not old.</summary>
    public bool IsPositionFresh { get; } = vehicle.PositionTime is { } time && now - time <= FreshFor;
}
