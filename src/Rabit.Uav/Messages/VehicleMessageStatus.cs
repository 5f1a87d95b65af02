using System;

namespace Rabit.Uav.Messages;

/// <summary>
/// What Communications reports of the messages between vehicles, at least once a second. A plain value; counts are
/// since the start.
/// </summary>
public struct VehicleMessageStatus
{
    /// <summary>Vehicles that were received within the last five announcement periods.</summary>
    public int Vehicles { get; set; }

    /// <summary>Messages of ours that are on their way, or wait.</summary>
    public int Waiting { get; set; }

    /// <summary>
    /// How good the common time base is here, the GPS time of our autopilot; null where there is none: messages of ours
    /// are marked so.
    /// </summary>
    public TimeSpan? TimeAccuracy { get; set; }

    /// <summary>What the exchange did.</summary>
    public VehicleExchangeCounters Counters { get; set; }
}
