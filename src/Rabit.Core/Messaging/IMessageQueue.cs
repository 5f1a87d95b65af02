using System;

namespace Rabit.Core.Messaging;

/// <summary>What the workspace needs of a queue, whatever its type.</summary>
internal interface IMessageQueue
{
    string Name { get; }

    QueueCounters Counters { get; }

    /// <summary>The run is over: nothing more is taken in, and who waits is told. What must be given back is.</summary>
    void Close();
}
