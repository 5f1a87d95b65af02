using System;

namespace Rabit.Core;

/// <summary>
/// The counters of a queue at one instant: pushed = popped + dropped + resident, always. A plain value.
/// </summary>
public readonly struct QueueCounters
{
    internal QueueCounters(
        long pushed, long popped, long dropped, long rejected, int resident, int highWater, int capacity)
    {
        Pushed = pushed;
        Popped = popped;
        Dropped = dropped;
        Rejected = rejected;
        Resident = resident;
        HighWater = highWater;
        Capacity = capacity;
    }

    /// <summary>Values that were put in.</summary>
    public long Pushed { get; }

    /// <summary>Values that were taken out by the receiver.</summary>
    public long Popped { get; }

    /// <summary>Values that were put in and had to make room for newer ones.</summary>
    public long Dropped { get; }

    /// <summary>
    /// Values that were never put in, because the queue was full; a push that waited in vain is one of them.
    /// </summary>
    public long Rejected { get; }

    /// <summary>Values that are in the queue now.</summary>
    public int Resident { get; }

    /// <summary>
    /// The most values that were in the queue at once. Where senders push at the same time a value that is popped just
    /// then may still count.
    /// </summary>
    public int HighWater { get; }

    /// <summary>How many fit in.</summary>
    public int Capacity { get; }

    /// <summary>All of them, in one line.</summary>
    public override string ToString() => FormattableString.Invariant(
        $"pushed {Pushed} = popped {Popped} + dropped {Dropped} + resident {Resident}; rejected {Rejected}; at most {HighWater} of {Capacity}");
}
