using System;
using System.Net;
using System.Net.Sockets;
using System.Threading;

namespace Rabit.Links;

/// <summary>
/// <c>udpbcast:ADDRESS:PORT</c>: sends to the broadcast address of a network, and so to all who listen on that port
/// there, and receives what any of them sends back to this computer's port, which the system chooses. One write is one
/// datagram. It does not receive what others broadcast: for that listen with <c>udpin</c>.
/// </summary>
/// <example>
/// <code>
/// byte[] heartbeat = [0xFD, 9, 0, 0];   // a whole frame in truth
/// using UdpBroadcastLink link = UdpBroadcastLink.Open("192.168.1.255", 14550);
/// link.Write(heartbeat, 0, heartbeat.Length);   // every ground station on that network receives it
/// </code>
/// </example>
public sealed class UdpBroadcastLink : IByteLink, INonBlockingWriter
{
    private readonly LinkLifetime _state;
    private readonly UdpSocket _socket;

    private UdpBroadcastLink(Socket socket, LinkLifetime state, IPEndPoint target, LinkOptions options)
    {
        _state = state;
        _socket = new UdpSocket(socket, state, DatagramExchange.Create(socket, state, options, target));
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

    /// <summary>Opens a link. Nothing is sent yet.</summary>
    /// <param name="address">
    /// The broadcast address of a network of this computer, for example <c>192.168.1.255</c>, or
    /// <c>255.255.255.255</c>; IPv4, since IPv6 has none.
    /// </param>
    /// <param name="port">Where the others listen, 1 to 65535.</param>
    /// <param name="options">How long a write may wait; the defaults if left out.</param>
    /// <exception cref="LinkException">The address is none of IPv4, or the like.</exception>
    public static UdpBroadcastLink Open(string address, int port, LinkOptions? options = null)
    {
        if (address is null) throw new ArgumentNullException(nameof(address));
        if (port is < 1 or > 65535) throw new ArgumentOutOfRangeException(nameof(port), port, "a port is 1 to 65535");
        string url = LinkUrl.ForHost(LinkKind.UdpBroadcast, address, port).ToString();
        if (!IPAddress.TryParse(address, out IPAddress? to) || to.AddressFamily != AddressFamily.InterNetwork)
            throw new LinkException(url, $"'{address}' is not a broadcast address of IPv4", linkEnded: true);
        options ??= LinkOptions.Default;

        Socket? socket = null;
        try
        {
            socket = UdpSocket.Create(AddressFamily.InterNetwork);
            socket.EnableBroadcast = true;
            socket.SendTimeout = options.WriteTimeoutMilliseconds;
            socket.Bind(new IPEndPoint(IPAddress.Any, 0));
            return new UdpBroadcastLink(socket, new LinkLifetime(url), new IPEndPoint(to, port), options);
        }
        catch (SocketException e)
        {
            socket?.Dispose();
            throw new LinkException(
                url, $"cannot send: {SocketFaults.Describe(e.SocketErrorCode)}", linkEnded: true, e, mayPass: true);
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
    public bool TryWrite(byte[] buffer, int offset, int count)
        => _state.IsWritable(buffer, offset, count) && _socket.TryWrite(buffer, offset, count);

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
