namespace Rabit.Core;

/// <summary>What a push really did.</summary>
public enum PushResult
{
    /// <summary>The value is in the queue.</summary>
    Queued,

    /// <summary>The value is in the queue, and the oldest one was dropped for it.</summary>
    QueuedDroppedOldest,

    /// <summary>The queue was full: the value is not in it.</summary>
    Rejected,
}
