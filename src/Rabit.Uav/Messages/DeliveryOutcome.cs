namespace Rabit.Uav.Messages;

/// <summary>What became of a message to other vehicles.</summary>
public enum DeliveryOutcome
{
    /// <summary>All that it was for have acknowledged it.</summary>
    Delivered,

    /// <summary>All of it was sent, and it was not to be acknowledged.</summary>
    Sent,

    /// <summary>
    /// Its lifetime ended before all of it was sent, or before all have acknowledged it. It may have been delivered:
    /// acknowledgements are lost too.
    /// </summary>
    Expired,

    /// <summary>All have answered, and some do not know its type, or not that version of it.</summary>
    NotUnderstood,

    /// <summary>It was for all or for a group, and no vehicle of it was received lately.</summary>
    NoReceiver,

    /// <summary>A newer message of its type took its place before it was sent: state only.</summary>
    Replaced,

    /// <summary>There was no room: too many messages wait.</summary>
    NoRoom,

    /// <summary>
    /// It cannot be sent: our own address is not known yet, or it does not fit into its form.
    /// </summary>
    Unsendable,
}
