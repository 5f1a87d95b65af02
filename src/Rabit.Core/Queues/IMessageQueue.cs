using Rabit.Core.Wiring;

namespace Rabit.Core.Queues;

/// <summary>What the workspace needs of a queue, whatever its type.</summary>
internal interface IMessageQueue : IConnector
{
    QueueCounters Counters { get; }

    /// <summary>
    /// The run is over: nothing more is taken in, and waiting senders and receivers are released. A push that is under
    /// way is either rejected, or in the counters that are read after this.
    /// </summary>
    void Close();

    /// <summary>After <see cref="Close"/>: returns what is left and must be returned.</summary>
    void DisposeRest();
}
