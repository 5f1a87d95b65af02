using System;
using System.Collections.Generic;
using Rabit.Core.Wiring;

namespace Rabit.Core.Queues;

/// <summary>What the wiring check needs of a queue's endpoint, whatever its type.</summary>
internal interface IQueueDeclaration
{
    int Capacity { get; }

    QueueFullMode FullMode { get; }

    TimeSpan? MaxWait { get; }

    /// <summary>Whether a sender holds a value that the queue rejected.</summary>
    bool IsHolding { get; }

    /// <summary>When the run is over: disposes such a value, where its type is disposable.</summary>
    void DisposeHeld();

    /// <summary>Whether the queue that these declare has a lock.</summary>
    bool NeedsLock(IReadOnlyList<EndpointDeclaration> endpoints);
}
