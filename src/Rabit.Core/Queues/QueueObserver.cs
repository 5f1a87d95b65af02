using System;
using Rabit.Core.Queues;

namespace Rabit.Core;

/// <summary>
/// Reads the counters of a queue of any type, for tools that know it by name only. Made by
/// <see cref="RabitWorkspace.ObserveQueues"/>; any thread.
/// </summary>
public sealed class QueueObserver
{
    private readonly IMessageQueue _queue;

    internal QueueObserver(IMessageQueue queue, Type valueType)
    {
        _queue = queue;
        ValueType = valueType;
    }

    /// <summary>The name of the queue.</summary>
    public string Name => _queue.Name;

    /// <summary>The type of its values.</summary>
    public Type ValueType { get; }

    /// <summary>Its counters as they are now.</summary>
    public QueueCounters ReadCounters() => _queue.Counters;
}
