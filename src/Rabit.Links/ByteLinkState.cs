namespace Rabit.Links;

/// <summary>Where a link is in its life.</summary>
public enum ByteLinkState
{
    /// <summary>It is being opened: a host is asked for a connection, or a name looked up.</summary>
    Opening,

    /// <summary>Open.</summary>
    Open,

    /// <summary>It is not there; it will be tried again.</summary>
    WaitingToReopen,

    /// <summary>It has ended, and will not be opened again.</summary>
    Closed,
}
