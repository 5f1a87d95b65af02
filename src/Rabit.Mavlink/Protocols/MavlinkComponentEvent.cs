namespace Rabit.Mavlink;

/// <summary>What happened to a component.</summary>
public enum MavlinkComponentEvent
{
    /// <summary>Its first heartbeat.</summary>
    Appeared,

    /// <summary>Its heartbeats stay away.</summary>
    Lost,

    /// <summary>A heartbeat after it was lost.</summary>
    Returned,

    /// <summary>Its system began anew: ask again for whatever it was asked for, and forget what it is no longer bound to.</summary>
    Rebooted,
}
