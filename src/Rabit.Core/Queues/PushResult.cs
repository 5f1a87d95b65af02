namespace Rabit.Core;

/// <summary>What a push really did.</summary>
public enum PushResult
{
    /// <summary>The value is in the queue.</summary>
    Queued,

    /// <summary>The value is in the queue, and the oldest one was dropped for it.</summary>
    QueuedDroppedOldest,

    /// <summary>The value is in the queue, in the place of the newest one, which was dropped for it.</summary>
    QueuedDroppedNewest,

    /// <summary>The queue was full, or the run is over: the value is not in it.</summary>
    Rejected,

    /// <summary>The queue was full for as long as a push may wait: the value is not in it.</summary>
    TimedOut,
}
