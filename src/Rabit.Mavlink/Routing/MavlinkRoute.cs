namespace Rabit.Mavlink;

/// <summary>Where a frame goes. A plain value.</summary>
public readonly struct MavlinkRoute
{
    internal MavlinkRoute(MavlinkRouteReason reason, bool deliverLocally, ulong forwardTo)
    {
        Reason = reason;
        DeliverLocally = deliverLocally;
        ForwardTo = forwardTo;
    }

    /// <summary>Which rule decided.</summary>
    public MavlinkRouteReason Reason { get; }

    /// <summary>Whether it is for us too.</summary>
    public bool DeliverLocally { get; }

    /// <summary>The links to write it to, unchanged: bit n is link n.</summary>
    public ulong ForwardTo { get; }

    /// <summary>Whether it is to be written to a link.</summary>
    /// <param name="link">0 to 63.</param>
    /// <returns>Whether the link's bit is set.</returns>
    public bool GoesTo(int link) => (uint)link < 64 && (ForwardTo & (1UL << link)) != 0;
}
