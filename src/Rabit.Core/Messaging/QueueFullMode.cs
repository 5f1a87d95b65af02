namespace Rabit.Core;

/// <summary>What happens to a push into a full queue. Declared by the receiver.</summary>
public enum QueueFullMode
{
    /// <summary>The push is refused and says so; what is in the queue stays.</summary>
    Reject,

    /// <summary>The oldest entry makes room, and is counted as dropped.</summary>
    DropOldest,

    /// <summary>The sender waits for room. For readers only: a manager never waits for another.</summary>
    Wait,
}
