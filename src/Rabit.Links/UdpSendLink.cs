using System;
using System.Net;
using System.Net.Sockets;
using System.Threading;

namespace Rabit.Links;

/// <summary>
/// <c>udpout:HOST:PORT</c>: sends to one UDP address and receives only from it. One write is one datagram. The peer may
/// come up later or go away: that it is not there is counted as a transient fault where the network says so, and seen
/// in no other way.
/// </summary>
public sealed class UdpSendLink : IByteLink
{
    private readonly LinkLifetime _state;
    private readonly UdpSocket _socket;

    private UdpSendLink(Socket socket, LinkLifetime state)
    {
        _state = state;
        _socket = new UdpSocket(socket, state, exchange: null);
    }

    /// <inheritdoc/>
    public string Url => _state.Url;

    /// <inheritdoc/>
    public bool Blocks => true;

    /// <inheritdoc/>
    public LinkCounters Counters => _state.Counters;

    /// <inheritdoc/>
    public ByteLinkState State => _state.State;

    /// <inheritdoc/>
    public string? LastFault => _state.LastFault;

    /// <summary>
    /// Opens a link. Nothing is sent yet, so whether the peer is there does not matter; its name must be known.
    /// </summary>
    /// <param name="host">Name or address of the peer; of several addresses the first IPv4 one is taken.</param>
    /// <param name="port">The peer's port, 1 to 65535.</param>
    /// <param name="options">How long a write may wait; the defaults if left out.</param>
    /// <exception cref="LinkException">The host is unknown, the network cannot be reached, or the like.</exception>
    public static UdpSendLink Open(string host, int port, LinkOptions? options = null)
        => Open(host, port, options, new LinkStop());

    internal static UdpSendLink Open(string host, int port, LinkOptions? options, LinkStop stop)
    {
        if (host is null) throw new ArgumentNullException(nameof(host));
        if (port is < 1 or > 65535) throw new ArgumentOutOfRangeException(nameof(port), port, "a port is 1 to 65535");
        string url = LinkUrl.ForHost(LinkKind.UdpSend, host, port).ToString();
        IPAddress peer = HostAddresses.Find(url, host, stop)[0];

        Socket? socket = null;
        try
        {
            socket = new Socket(peer.AddressFamily, SocketType.Dgram, ProtocolType.Udp)
            {
                SendTimeout = (options ?? LinkOptions.Default).WriteTimeoutMilliseconds,
            };
            socket.Connect(new IPEndPoint(peer, port));
            return new UdpSendLink(socket, new LinkLifetime(url));
        }
        catch (SocketException e)
        {
            socket?.Dispose();
            throw new LinkException(
                url, $"cannot send: {SocketFaults.Describe(e.SocketErrorCode)}", linkEnded: true, e,
                mayPass: true);
        }
    }

    /// <inheritdoc/>
    public LinkRead Read(byte[] buffer, int timeoutMilliseconds = Timeout.Infinite)
        => _socket.Read(buffer, timeoutMilliseconds);

    /// <inheritdoc/>
    public void Write(byte[] buffer, int offset, int count)
    {
        if (_state.CheckWrite(buffer, offset, count)) _socket.Write(buffer, offset, count);
    }

    /// <inheritdoc/>
    public void Unblock() => _socket.End(LinkLifetime.UnblockedReason);

    /// <inheritdoc/>
    public void SetReadableCallback(Action? callback)
    {
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        if (_state.TryDispose()) Unblock();
    }
}
