using System;

namespace Rabit.Uav.Messages;

/// <summary>
/// What a mission does where the ground station, once received, is no longer: times since its last heartbeat.
/// Immutable. In flight, before the autopilot's own failsafe for that, which has priority, only where that is off or
/// slower.
/// </summary>
public sealed class GroundStationLoss
{
    /// <summary>Carries on, whatever becomes of the ground station.</summary>
    public static GroundStationLoss Continue { get; } = new() { HoldAfter = null, ReturnAfter = null };

    /// <summary>When the vehicle holds, until the ground station is back; null for never. 5 to 600 s.</summary>
    /// <value>The default is 10 s.</value>
    public TimeSpan? HoldAfter { get; init; } = TimeSpan.FromSeconds(10);

    /// <summary>When the vehicle returns to launch; null for never. 5 to 3600 s, not before it holds.</summary>
    /// <value>The default is 30 s.</value>
    public TimeSpan? ReturnAfter { get; init; } = TimeSpan.FromSeconds(30);
}
