namespace Rabit.Uav.Communications;

/// <summary>What became of the vehicle messages of one type, since the start. A plain value.</summary>
public readonly struct VehicleMessageCounters
{
    internal VehicleMessageCounters(
        int payloadType, long sent, long rateLimited, long unsendable, long delivered, long echoes, long duplicates,
        long malformed, long noRoom)
    {
        PayloadType = payloadType;
        Sent = sent;
        RateLimited = rateLimited;
        Unsendable = unsendable;
        Delivered = delivered;
        Echoes = echoes;
        Duplicates = duplicates;
        Malformed = malformed;
        NoRoom = noRoom;
    }

    /// <summary>Which type.</summary>
    public int PayloadType { get; }

    /// <summary>Copies that went to a link.</summary>
    public long Sent { get; }

    /// <summary>Copies that were dropped, since their link had reached its rate limit.</summary>
    public long RateLimited { get; }

    /// <summary>
    /// Messages that were dropped: our address is not known yet, their target was not seen on any link, or they do not
    /// fit into their form.
    /// </summary>
    public long Unsendable { get; }

    /// <summary>Messages that came in and were handed on.</summary>
    public long Delivered { get; }

    /// <summary>Messages that came in from our own system, and were dropped.</summary>
    public long Echoes { get; }

    /// <summary>Messages that came in a second time, and were dropped.</summary>
    public long Duplicates { get; }

    /// <summary>What came in as such a message and is none, and was dropped.</summary>
    public long Malformed { get; }

    /// <summary>Messages that came in and were dropped, since their queue was full.</summary>
    public long NoRoom { get; }
}
