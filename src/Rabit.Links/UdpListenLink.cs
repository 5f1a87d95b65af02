using System;
using System.Net;
using System.Net.Sockets;
using System.Threading;

namespace Rabit.Links;

/// <summary>
/// <c>udpin:ADDRESS:PORT</c>: waits on a UDP port and receives from any sender; <see cref="LinkRead.Peer"/> says from
/// which. Writes go to all of them, at most 64: one that sends nothing for a minute
/// (<see cref="LinkOptions.PeerIdleTime"/>) is forgotten, and where there are too many the one that was silent longest
/// gives way; both are counted. While there is none, and while the network is down, writes are dropped and counted. One
/// write is one datagram to each. Allocates nothing per datagram on .NET; Mono's calls make addresses
/// for each.
/// </summary>
/// <example>
/// <code>
/// using UdpListenLink link = UdpListenLink.Open("0.0.0.0", 14550);
/// var buffer = new byte[4096];
/// LinkRead read = link.Read(buffer);        // waits for a datagram of anyone
/// link.Write(buffer, 0, read.Count);        // goes back to its sender, and to all before
/// </code>
/// </example>
public sealed class UdpListenLink : IByteLink, INonBlockingWriter
{
    private readonly LinkLifetime _state;
    private readonly UdpSocket _socket;

    private UdpListenLink(Socket socket, LinkLifetime state, IPEndPoint local, LinkOptions options)
    {
        _state = state;
        _socket = new UdpSocket(socket, state, DatagramExchange.Create(socket, state, options));
        Port = local.Port;
    }

    /// <inheritdoc/>
    public string Url => _state.Url;

    /// <summary>The port it listens on.</summary>
    public int Port { get; }

    /// <inheritdoc/>
    public bool Blocks => true;

    /// <inheritdoc/>
    public LinkCounters Counters => _state.Counters;

    /// <inheritdoc/>
    public ByteLinkState State => _state.State;

    /// <inheritdoc/>
    public string? LastFault => _state.LastFault;

    /// <summary>Opens a link.</summary>
    /// <param name="address">
    /// The address of this computer to listen on, or a name for it; <c>0.0.0.0</c> is all of them for IPv4.
    /// </param>
    /// <param name="port">1 to 65535, or 0 for any free one: <see cref="Port"/> says which.</param>
    /// <param name="options">How long a write may wait, when a peer is forgotten; the defaults if left out.</param>
    /// <exception cref="LinkException">
    /// The port is in use, this computer does not have the address, or the like.
    /// </exception>
    public static UdpListenLink Open(string address, int port, LinkOptions? options = null)
        => Open(address, port, options, new LinkStop());

    internal static UdpListenLink Open(string address, int port, LinkOptions? options, LinkStop stop)
    {
        if (address is null) throw new ArgumentNullException(nameof(address));
        if (port is < 0 or > 65535) throw new ArgumentOutOfRangeException(nameof(port), port, "a port is 0 to 65535");
        string url = LinkUrl.ForHost(LinkKind.UdpListen, address, port).ToString();
        options ??= LinkOptions.Default;
        IPAddress own = HostAddresses.Find(url, address, stop)[0];

        Socket? socket = null;
        try
        {
            socket = UdpSocket.Create(own.AddressFamily);
            socket.SendTimeout = options.WriteTimeoutMilliseconds;
            socket.Bind(new IPEndPoint(own, port));
            var local = (IPEndPoint)socket.LocalEndPoint!;
            return new UdpListenLink(
                socket, new LinkLifetime(LinkUrl.ForHost(LinkKind.UdpListen, address, local.Port).ToString()), local,
                options);
        }
        catch (SocketException e)
        {
            socket?.Dispose();
            throw new LinkException(
                url, $"cannot listen: {SocketFaults.Describe(e.SocketErrorCode)}", linkEnded: true, e);
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
