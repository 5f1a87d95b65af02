using System;

namespace Rabit.Core.Queues;

/// <summary>What the wiring check needs of a queue's endpoint, whatever its type.</summary>
internal interface IQueueDeclaration
{
    int Capacity { get; }

    QueueFullMode FullMode { get; }

    TimeSpan? MaxWait { get; }
}
