using System;

namespace Rabit.Mavlink;

/// <summary>What a router may do with a link.</summary>
[Flags]
public enum MavlinkLinkRules
{
    /// <summary>Received frames are for local use only: a recorded log beside live links.</summary>
    ReceiveOnly = 0,

    /// <summary>Frames may be sent into the link.</summary>
    Send = 1,

    /// <summary>Frames that come from the link may be forwarded to other links.</summary>
    ForwardFrom = 2,

    /// <summary>A link like any other.</summary>
    Live = Send | ForwardFrom,
}
