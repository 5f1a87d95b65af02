namespace Rabit.Core.Wiring;

/// <summary>What an endpoint does.</summary>
internal enum EndpointRole
{
    Publish,
    Subscribe,
    Send,
    Receive,
}
