using System;
using System.Net;
using System.Net.Sockets;
using System.Threading;

namespace Rabit.Links;

/// <summary>
/// <c>udpout:HOST:PORT</c>: sends to one UDP address and receives only from it. One write is one datagram. The peer may
/// come up later or go away: that it is not there is counted as a transient fault where the network says so, and seen
/// in no other way. After 30 s of silence the name of the host is looked up again
/// (<see cref="LinkOptions.ResolveAfter"/>); it may have moved. The thread that reads does that, and sends what
/// <see cref="LinkOptions.KeepAlive"/> asks for.
/// </summary>
public sealed class UdpSendLink : IByteLink, INonBlockingWriter
{
    private readonly LinkLifetime _state;
    private readonly LinkStop _stop = new();
    private readonly int _port;
    private readonly int _writeTimeoutMilliseconds;
    private readonly UdpSendChores _chores;
    private readonly Func<LinkStop, IPAddress> _lookUp;
    private IPAddress _peer; // reader's thread
    private UdpSocket _socket; // volatile access; replaced by the reader's thread

    private UdpSendLink(
        LinkLifetime state, int port, LinkOptions options, bool isNamed, Func<LinkStop, IPAddress> lookUp,
        LinkStop stop)
    {
        _state = state;
        _port = port;
        _writeTimeoutMilliseconds = options.WriteTimeoutMilliseconds;
        _chores = new UdpSendChores(options, isNamed);
        _lookUp = lookUp;
        _peer = lookUp(stop);
        _socket = Connect(_peer);
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
    /// <param name="options">
    /// How long a write may wait, whether the way is kept open; the defaults if left out.
    /// </param>
    /// <exception cref="LinkException">The host is unknown, the network cannot be reached, or the like.</exception>
    public static UdpSendLink Open(string host, int port, LinkOptions? options = null)
        => Open(host, port, options, new LinkStop());

    internal static UdpSendLink Open(
        string host, int port, LinkOptions? options, LinkStop stop, Func<LinkStop, IPAddress>? lookUp = null)
    {
        if (host is null) throw new ArgumentNullException(nameof(host));
        if (port is < 1 or > 65535) throw new ArgumentOutOfRangeException(nameof(port), port, "a port is 1 to 65535");
        string url = LinkUrl.ForHost(LinkKind.UdpSend, host, port).ToString();
        try
        {
            return new UdpSendLink(
                new LinkLifetime(url), port, options ?? LinkOptions.Default, UdpSendChores.IsName(host),
                lookUp ?? (s => HostAddresses.Find(url, host, s)[0]), stop);
        }
        catch (SocketException e)
        {
            throw new LinkException(
                url, $"cannot send: {SocketFaults.Describe(e.SocketErrorCode)}", linkEnded: true, e, mayPass: true);
        }
    }

    /// <inheritdoc/>
    public LinkRead Read(byte[] buffer, int timeoutMilliseconds = Timeout.Infinite)
    {
        if (!_chores.Any) return _socket.Read(buffer, timeoutMilliseconds);
        _state.CheckRead(buffer, timeoutMilliseconds);
        var deadline = new Deadline(timeoutMilliseconds);
        while (true)
        {
            int left = deadline.Milliseconds;
            int wait = _chores.Milliseconds;
            LinkRead read = _socket.Read(buffer, left == Timeout.Infinite ? wait : Math.Min(wait, left));
            if (read.Kind == LinkReadKind.Bytes) _chores.Received();
            if (read.Kind != LinkReadKind.NothingYet) return read;
            DoChores();
            if (deadline.HasPassed) return read;
        }
    }

    /// <inheritdoc/>
    public void Write(byte[] buffer, int offset, int count)
    {
        if (!_state.CheckWrite(buffer, offset, count)) return;
        Volatile.Read(ref _socket).Write(buffer, offset, count);
        _chores.Written();
    }

    /// <inheritdoc/>
    public bool TryWrite(byte[] buffer, int offset, int count)
    {
        if (!_state.IsWritable(buffer, offset, count)
            || !Volatile.Read(ref _socket).TryWrite(buffer, offset, count))
            return false;
        _chores.Written();
        return true;
    }

    /// <inheritdoc/>
    public void Unblock()
    {
        if (!_state.TryEnd(LinkLifetime.UnblockedReason)) return;
        _stop.Request();
        Volatile.Read(ref _socket).Close();
    }

    /// <inheritdoc/>
    public void SetReadableCallback(Action? callback)
    {
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        if (_state.TryDispose()) Unblock();
    }

    private void DoChores()
    {
        if (_chores.IsKeepAliveDue)
        {
            _socket.KeepAlive();
            _chores.Written();
        }

        if (!_chores.IsLookUpDue) return;
        try
        {
            IPAddress found = _lookUp(_stop);
            if (!found.Equals(_peer)) Replace(found);
        }
        catch (Exception e) when (e is LinkException or SocketException)
        {
            _state.TransientFault(); // the name service is not there either
        }

        _chores.LookedUp();
    }

    private void Replace(IPAddress peer)
    {
        UdpSocket old = _socket;
        Volatile.Write(ref _socket, Connect(peer));
        _peer = peer;
        old.Retire();

        // A stop that came in between closed the old one.
        if (_state.EndReason is not null) _socket.Close();
    }

    private UdpSocket Connect(IPAddress peer)
    {
        Socket socket = UdpSocket.Create(peer.AddressFamily);
        try
        {
            socket.SendTimeout = _writeTimeoutMilliseconds;
            socket.Connect(new IPEndPoint(peer, _port));
        }
        catch
        {
            socket.Dispose();
            throw;
        }

        return new UdpSocket(socket, _state, exchange: null);
    }
}
