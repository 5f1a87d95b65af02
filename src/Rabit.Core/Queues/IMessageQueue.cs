using Rabit.Core.Wiring;

namespace Rabit.Core.Queues;

/// <summary>What the workspace needs of a queue, whatever its type.</summary>
internal interface IMessageQueue : IConnector
{
    QueueCounters Counters { get; }

    /// <summary>After <see cref="IConnector.Close"/>: returns what is left and must be returned.</summary>
    void DisposeRest();
}
