namespace Rabit.Uav.Communications;

/// <summary>
/// What became of the vehicle messages of one type, since the start. A plain value. Posted is the sum of unsendable,
/// sent, acknowledged, undelivered and what still waits.
/// </summary>
public readonly struct VehicleMessageCounters
{
    /// <summary>Which type.</summary>
    public int MessageType { get; internal init; }

    /// <summary>Messages that were taken from the outgoing queue.</summary>
    public long Posted { get; internal init; }

    /// <summary>
    /// Of them those that were dropped: our address is not known yet, or they do not fit into their form.
    /// </summary>
    public long Unsendable { get; internal init; }

    /// <summary>Of them those that went out and are not acknowledged.</summary>
    public long Sent { get; internal init; }

    /// <summary>Of them those that all they were for have acknowledged.</summary>
    public long Acknowledged { get; internal init; }

    /// <summary>
    /// Of them those that expired, were replaced, had no receiver or no room, or were not understood: the exchange
    /// counts what expired, the reports say each.
    /// </summary>
    public long Undelivered { get; internal init; }

    /// <summary>Reports of them for which the queue had no room.</summary>
    public long ReportsDropped { get; internal init; }

    /// <summary>Messages that came in and were handed on.</summary>
    public long Delivered { get; internal init; }

    /// <summary>What came in as such a message and is none, and was dropped.</summary>
    public long Malformed { get; internal init; }

    /// <summary>Messages that came in and were dropped, since their queue was full.</summary>
    public long NoRoom { get; internal init; }
}
