namespace Rabit.Mavlink;

/// <summary>The decisions of a router since it was made. A copy, taken at one moment.</summary>
public readonly struct MavlinkRouterCounters
{
    internal MavlinkRouterCounters(
        long delivered, long forwarded, long unknownTargets, long ourOwn, long linkLocal, long sourcesRefused)
    {
        Delivered = delivered;
        Forwarded = forwarded;
        UnknownTargets = unknownTargets;
        OurOwn = ourOwn;
        LinkLocal = linkLocal;
        SourcesRefused = sourcesRefused;
    }

    /// <summary>Frames for local use.</summary>
    public long Delivered { get; }

    /// <summary>Received frames that are forwarded to one other link or more.</summary>
    public long Forwarded { get; }

    /// <summary>Frames, received or ours, for a component that was not seen on any link.</summary>
    public long UnknownTargets { get; }

    /// <summary>Received frames with our own address.</summary>
    public long OurOwn { get; }

    /// <summary>Frames of messages that never leave their link.</summary>
    public long LinkLocal { get; }

    /// <summary>Frames whose sender could not be learned, since the table is full.</summary>
    public long SourcesRefused { get; }
}
