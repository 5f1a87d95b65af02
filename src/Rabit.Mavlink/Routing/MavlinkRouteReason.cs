namespace Rabit.Mavlink;

/// <summary>Which rule decided where a frame goes.</summary>
public enum MavlinkRouteReason
{
    /// <summary>Broadcast: no target system, or target system 0.</summary>
    Broadcast,

    /// <summary>
    /// Its id is unknown, so that its address cannot be read: treated as broadcast, but not for local use.
    /// </summary>
    UnknownMessage,

    /// <summary>For us alone.</summary>
    ForUs,

    /// <summary>For every component of our system: us, and the others where they were seen.</summary>
    ForOurSystem,

    /// <summary>For another component, which was seen on one link or more.</summary>
    ForOthers,

    /// <summary>For another component, which was not seen on any link: it is not forwarded.</summary>
    UnknownTarget,

    /// <summary>The message concerns one link only and never leaves it: SETUP_SIGNING, RADIO_STATUS, RADIO.</summary>
    LinkLocal,

    /// <summary>
    /// It carries our own address: an echo, or our part of a recorded log. Neither routed nor learned.
    /// </summary>
    OurOwn,
}
