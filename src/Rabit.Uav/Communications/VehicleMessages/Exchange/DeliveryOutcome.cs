namespace Rabit.Uav.Communications;

/// <summary>What became of a message to other vehicles that was to be acknowledged.</summary>
internal enum DeliveryOutcome
{
    /// <summary>All that it was for have acknowledged it.</summary>
    Delivered,

    /// <summary>
    /// Its lifetime ended before all have acknowledged it. It may have been delivered: acknowledgements are lost too.
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
}
