namespace Rabit.Core.Messaging;

/// <summary>What the workspace needs of a queue, whatever its type.</summary>
internal interface IMessageQueue
{
    string Name { get; }

    QueueCounters Counters { get; }

    /// <summary>The run is over: nobody takes out what is left in it, nor what may still come.</summary>
    void Close();
}
