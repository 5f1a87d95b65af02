namespace Rabit.Mavlink;

/// <summary>Where a command is.</summary>
internal enum CommandPhase
{
    /// <summary>No command.</summary>
    Free,

    /// <summary>Not sent yet: one like it is not done with.</summary>
    Queued,

    /// <summary>Sent, or to be sent at once.</summary>
    Sending,

    /// <summary>To be sent again later.</summary>
    Pausing,

    /// <summary>Asked for to be cancelled.</summary>
    Cancelling,

    /// <summary>The outcome waits for the caller.</summary>
    Over,

    /// <summary>The caller has the outcome; late answers may come.</summary>
    Settled,
}
