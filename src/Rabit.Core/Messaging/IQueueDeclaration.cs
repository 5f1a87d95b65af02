using System;

namespace Rabit.Core.Messaging;

/// <summary>What the wiring check needs of a queue's end, whatever its type.</summary>
internal interface IQueueDeclaration
{
    int Capacity { get; }

    QueueFullMode FullMode { get; }

    TimeSpan? WaitAtMost { get; }
}
