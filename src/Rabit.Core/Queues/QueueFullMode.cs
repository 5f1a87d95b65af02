namespace Rabit.Core;

/// <summary>
/// What happens to a push into a full queue: rejection, loss or back-pressure. Declared by the receiver.
/// </summary>
public enum QueueFullMode
{
    /// <summary>The push is refused and says so; what is in the queue stays.</summary>
    Reject,

    /// <summary>The oldest entry makes room, and is counted as dropped.</summary>
    DropOldest,

    /// <summary>
    /// The newest entry makes room, and is counted as dropped: the pushed value takes its place, after the older ones.
    /// </summary>
    DropNewest,

    /// <summary>
    /// Back-pressure: the sender waits for room, for a limited time if the receiver says so. For readers and for async
    /// code outside managers: a manager never waits for another, so a manager that sends to such a queue is a wiring
    /// fault.
    /// </summary>
    Wait,
}
