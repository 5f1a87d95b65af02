namespace Rabit.Core.Wiring;

/// <summary>
/// What joins all endpoints of one name: the global copy of a message (a topic of publish-subscribe), or a message
/// queue.
/// </summary>
internal interface IConnector
{
    string Name { get; }

    /// <summary>
    /// The run is over: all that wait are released, and a queue takes nothing more in. A push that is under way is
    /// either rejected, or in the counters that are read after this.
    /// </summary>
    void Close();
}
