using System;

namespace Rabit.Core;

/// <summary>How one queue ended. Immutable.</summary>
public sealed class QueueResult
{
    internal QueueResult(string name, QueueCounters counters, int held)
    {
        Name = name;
        Counters = counters;
        Held = held;
    }

    /// <summary>The queue.</summary>
    public string Name { get; }

    /// <summary>Its counters when all managers, readers and writers had ended.</summary>
    public QueueCounters Counters { get; }

    /// <summary>
    /// Values that senders still held because the queue had been full (<see cref="QueueSender{T}.TryPushOrHold"/>).
    /// </summary>
    public int Held { get; }

    /// <summary>One line.</summary>
    public override string ToString()
        => FormattableString.Invariant(
            $"queue {Name}: {Counters.Resident} values were left, {Counters.Dropped} dropped, {Counters.Rejected} rejected of {Counters.Pushed + Counters.Rejected}")
            + (Held > 0 ? FormattableString.Invariant($", {Held} held by senders") : string.Empty);
}
