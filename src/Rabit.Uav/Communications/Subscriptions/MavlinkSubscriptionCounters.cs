namespace Rabit.Uav.Communications;

/// <summary>What went to the queue of one <see cref="MavlinkSubscription"/> since the start. A plain value.</summary>
public readonly struct MavlinkSubscriptionCounters
{
    internal MavlinkSubscriptionCounters(string queue, long delivered, long dropped)
    {
        Queue = queue;
        Delivered = delivered;
        Dropped = dropped;
    }

    /// <summary>The name of the queue.</summary>
    public string Queue { get; }

    /// <summary>Frames that were put into the queue and not dropped for newer ones since.</summary>
    public long Delivered { get; }

    /// <summary>
    /// Frames that were dropped, since the queue was full: the newest or the oldest, by the rule of the queue.
    /// </summary>
    public long Dropped { get; }
}
