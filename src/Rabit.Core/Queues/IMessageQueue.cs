using Rabit.Core.Wiring;

namespace Rabit.Core.Queues;

/// <summary>What the workspace needs of a queue, whatever its type.</summary>
internal interface IMessageQueue : IConnector
{
    QueueCounters Counters { get; }

    /// <summary>
    /// The run is over: nothing more is taken in, waiting senders and receivers are released, and what must be returned
    /// is returned.
    /// </summary>
    void Close();
}
