namespace Rabit.Core.Wiring;

/// <summary>
/// What joins all endpoints of one name: the global copy of a message (a topic of publish-subscribe), or a message
/// queue.
/// </summary>
internal interface IConnector
{
    string Name { get; }
}
