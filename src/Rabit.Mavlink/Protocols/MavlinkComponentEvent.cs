namespace Rabit.Mavlink;

/// <summary>A change in the connection of a component.</summary>
public enum MavlinkComponentEvent
{
    /// <summary>Its first heartbeat.</summary>
    Appeared,

    /// <summary>No heartbeat within the time-out.</summary>
    Lost,

    /// <summary>A heartbeat after it was lost.</summary>
    Returned,

    /// <summary>Its system rebooted: message rates and the like have to be requested again.</summary>
    Rebooted,
}
