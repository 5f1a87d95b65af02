using System;
using Rabit.Mavlink;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>What a command is planned by.</summary>
internal readonly struct CommandContext(
    in VehicleState vehicle, TimeSpan now, double lastSpeedMetresPerSecond, bool isStreaming, MavlinkAddress own)
{
    private static readonly TimeSpan FreshFor = TimeSpan.FromSeconds(3);

    public VehicleState Vehicle { get; } = vehicle;

    /// <summary>The speed of the last command to go to a place; NaN where something else came in between.</summary>
    public double LastSpeedMetresPerSecond { get; } = lastSpeedMetresPerSecond;

    /// <summary>Whether set-points are streamed and the autopilot is in OFFBOARD.</summary>
    public bool IsStreaming { get; } = isStreaming;

    /// <summary>Who we are.</summary>
    public MavlinkAddress Own { get; } = own;

    /// <summary>Altitude of home above mean sea level, metres.</summary>
    public double HomeAltitudeAmslMetres => Vehicle.Position.AltitudeAmslMetres - Vehicle.HeightAboveHomeMetres;

    /// <summary>Whether the position is known and not old.</summary>
    public bool IsPositionFresh { get; } = vehicle.PositionTime is { } time && now - time <= FreshFor;
}
