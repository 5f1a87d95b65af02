namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Faults that the exploration of batches that race with the close of a queue with many senders must find.
/// </summary>
public enum SeededBatchFault
{
    None,

    /// <summary>What is left is counted before the queue is closed.</summary>
    CountersBeforeTheClose,

    /// <summary>The close sets a flag that senders look at, and leaves the tail in their reach.</summary>
    CloseByAFlag,

    /// <summary>
    /// A batch reserves its places one by one, and is rejected whole where the queue is closed in between.
    /// </summary>
    ReservesOneByOne,

    /// <summary>A batch counts as put in whole, though there was room for a part of it.</summary>
    CountsWhatWasOffered,

    /// <summary>The tail is moved by a write, not by a swap.</summary>
    NoSwap,

    /// <summary>
    /// The receiver goes by the tail, not by the sequences: places are reserved before they are written.
    /// </summary>
    ReceiverByTheTail,
}
