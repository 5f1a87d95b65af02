namespace Rabit.Mavlink.Protocols;

/// <summary>How far the exchange of a command is.</summary>
internal enum CommandPhase
{
    /// <summary>No command.</summary>
    Free,

    /// <summary>Not sent yet: one of the same kind is still under way.</summary>
    Queued,

    /// <summary>Sent, or to be sent at once.</summary>
    Sending,

    /// <summary>To be sent again later.</summary>
    Pausing,

    /// <summary>Its cancellation was requested.</summary>
    Cancelling,

    /// <summary>Ended; the caller has not taken the outcome yet.</summary>
    Completed,

    /// <summary>Ended, and the outcome taken; late answers may arrive.</summary>
    OutcomeTaken,
}
