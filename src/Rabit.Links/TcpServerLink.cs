using System;
using System.Collections.Generic;
using System.Net;
using System.Net.Sockets;
using System.Threading;

namespace Rabit.Links;

/// <summary>
/// <c>tcpin:ADDRESS:PORT</c>: a TCP server, as an autopilot in simulation is. Reads from all its clients, of which
/// <see cref="LinkRead.Peer"/> says whose bytes they are, and writes to all. A write never waits: a client that does
/// not read is passed by, and dropped when it has taken nothing for 10 s; what no client takes is dropped and counted.
/// The link stays when clients come and go.
/// </summary>
/// <example>
/// <code>
/// using TcpServerLink link = TcpServerLink.Open("0.0.0.0", 5760);
/// LinkRead read = link.Read(buffer);        // waits for a client, and for its bytes
/// link.Write(buffer, 0, read.Count);        // goes to all clients
/// </code>
/// </example>
public sealed class TcpServerLink : IByteLink
{
    /// <summary>How many clients there may be; a further one displaces that which was silent longest.</summary>
    public const int MaxClients = 16;

    private static readonly TimeSpan StallLimit = TimeSpan.FromSeconds(10);
    private static readonly byte[] WakeByte = [1];

    private readonly LinkLifetime _state;
    private readonly Socket _listener;
    private readonly Socket _wake; // sends to itself, which ends a wait
    private readonly TimeProvider _clock;
    private readonly object _gate = new();
    private readonly TcpServerClient?[] _clients = new TcpServerClient?[MaxClients]; // guarded by _gate
    private readonly List<Socket> _readable = []; // reader's thread, as all below
    private readonly List<Socket> _writable = [];
    private int _lastSlot; // given to a client last
    private int _lastRead; // read last

    private TcpServerLink(Socket listener, Socket wake, LinkLifetime state, LinkOptions options)
    {
        _listener = listener;
        _wake = wake;
        _state = state;
        _clock = options.Clock;
        Port = ((IPEndPoint)listener.LocalEndPoint!).Port;
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

    /// <summary>How many clients are connected. Any thread.</summary>
    public int Clients
    {
        get
        {
            lock (_gate) return Array.FindAll(_clients, c => c is not null).Length;
        }
    }

    /// <summary>Listens.</summary>
    /// <param name="address">
    /// The address of this computer to listen on, or a name for it; <c>0.0.0.0</c> is all of them for IPv4.
    /// </param>
    /// <param name="port">1 to 65535, or 0 for any free one: <see cref="Port"/> says which.</param>
    /// <param name="options">The clock; the defaults if left out.</param>
    /// <exception cref="LinkException">
    /// The port is in use, this computer does not have the address, or the like.
    /// </exception>
    public static TcpServerLink Open(string address, int port, LinkOptions? options = null)
        => Open(address, port, options, new LinkStop());

    internal static TcpServerLink Open(string address, int port, LinkOptions? options, LinkStop stop)
    {
        if (address is null) throw new ArgumentNullException(nameof(address));
        if (port is < 0 or > 65535) throw new ArgumentOutOfRangeException(nameof(port), port, "a port is 0 to 65535");
        string url = LinkUrl.ForHost(LinkKind.TcpServer, address, port).ToString();
        IPAddress own = HostAddresses.Find(url, address, stop)[0];

        Socket? listener = null;
        Socket? wake = null;
        try
        {
            listener = new Socket(own.AddressFamily, SocketType.Stream, ProtocolType.Tcp) { Blocking = false };
            listener.Bind(new IPEndPoint(own, port));
            listener.Listen(MaxClients);
            wake = UdpSocket.Create(AddressFamily.InterNetwork);
            wake.Blocking = false;
            wake.Bind(new IPEndPoint(IPAddress.Loopback, 0));
            wake.Connect(wake.LocalEndPoint!);
            int chosen = ((IPEndPoint)listener.LocalEndPoint!).Port;
            return new TcpServerLink(
                listener, wake, new LinkLifetime(LinkUrl.ForHost(LinkKind.TcpServer, address, chosen).ToString()),
                options ?? LinkOptions.Default);
        }
        catch (SocketException e)
        {
            listener?.Dispose();
            wake?.Dispose();
            throw new LinkException(
                url, $"cannot listen: {SocketFaults.Describe(e.SocketErrorCode)}", linkEnded: true, e);
        }
    }

    /// <inheritdoc/>
    public LinkRead Read(byte[] buffer, int timeoutMilliseconds = Timeout.Infinite)
    {
        _state.CheckRead(buffer, timeoutMilliseconds);
        var deadline = new Deadline(timeoutMilliseconds);
        while (true)
        {
            if (_state.EndReason is { } reason) return LinkRead.Ended(reason);
            bool isTimeUp = !WaitForWork(deadline.Milliseconds) && deadline.HasPassed;
            if (_state.EndReason is not null) continue;
            if (_readable.Contains(_wake)) Drain(_wake, buffer);
            if (_readable.Contains(_listener)) Accept();
            if (_writable.Count > 0) SendRests();
            if (TryReadClient(buffer, out LinkRead read)) return read;
            if (isTimeUp) return LinkRead.NothingYet;
        }
    }

    /// <inheritdoc/>
    public void Write(byte[] buffer, int offset, int count)
    {
        if (!_state.CheckWrite(buffer, offset, count)) return;
        bool isTaken = false;
        bool hasRest = false;
        lock (_gate)
        {
            for (int slot = 0; slot < MaxClients; slot++)
            {
                if (_clients[slot] is not { } client) continue;
                bool isAlive = client.TryWrite(buffer, offset, count, out bool isTakenByIt);
                isTaken |= isTakenByIt;
                hasRest |= client.HasRest;
                if (!isAlive || client.StalledFor > StallLimit) Remove(slot);
            }
        }

        if (isTaken) _state.Sent(count);
        else _state.Dropped(count);
        if (hasRest) Wake();
    }

    /// <inheritdoc/>
    public void Unblock()
    {
        if (!_state.TryEnd(LinkLifetime.UnblockedReason)) return;
        Wake();
        _listener.Dispose();
        lock (_gate)
        {
            for (int slot = 0; slot < MaxClients; slot++) Remove(slot);
        }
    }

    /// <inheritdoc/>
    public void SetReadableCallback(Action? callback)
    {
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        if (!_state.TryDispose()) return;
        Unblock();
        _wake.Dispose();
    }

    // Leaves in the two lists what there is to do. False where there is nothing.
    private bool WaitForWork(int milliseconds)
    {
        _readable.Clear();
        _writable.Clear();
        _readable.Add(_wake);
        _readable.Add(_listener);
        lock (_gate)
        {
            foreach (TcpServerClient? client in _clients)
            {
                if (client is null) continue;
                _readable.Add(client.Socket);
                if (client.HasRest) _writable.Add(client.Socket);
            }
        }

        try
        {
            int microseconds = milliseconds == Timeout.Infinite
                ? -1
                : (int)Math.Min(milliseconds * 1000L, int.MaxValue);
            Socket.Select(_readable, _writable, null, microseconds);
            return _readable.Count + _writable.Count > 0;
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            // One of them was closed by a writer: the next wait is without it.
            _readable.Clear();
            _writable.Clear();
            return false;
        }
    }

    private void Accept()
    {
        try
        {
            Socket socket = _listener.Accept();
            socket.Blocking = false;
            socket.NoDelay = true;
            lock (_gate)
            {
                if (_state.EndReason is not null) socket.Dispose();
                else _clients[FreeSlot()] = new TcpServerClient(socket, _clock);
            }
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            _state.TransientFault(); // a client that was gone at once
        }
    }

    // A number that was not used for long, so that the bytes of one client do not follow those of another.
    private int FreeSlot()
    {
        int oldest = 0;
        for (int step = 1; step <= MaxClients; step++)
        {
            int slot = (_lastSlot + step) % MaxClients;
            if (_clients[slot] is not { } client) return _lastSlot = slot;
            if (client.LastReceived < _clients[oldest]!.LastReceived) oldest = slot;
        }

        _state.PeerDisplaced();
        Remove(oldest);
        return _lastSlot = oldest;
    }

    private bool TryReadClient(byte[] buffer, out LinkRead read)
    {
        lock (_gate)
        {
            // From the one behind that which was read last: a client that floods keeps no other waiting.
            for (int step = 1; step <= MaxClients; step++)
            {
                int slot = (_lastRead + step) % MaxClients;
                if (_clients[slot] is not { } client || !_readable.Contains(client.Socket)) continue;
                int count = Receive(client.Socket, buffer);
                if (count == 0) Remove(slot);
                if (count <= 0) continue;
                client.LastReceived = _clock.GetTimestamp();
                _lastRead = slot;
                read = _state.Arrived(count, slot);
                return true;
            }
        }

        read = default;
        return false;
    }

    // Bytes, 0 where the client is gone, -1 for none.
    private static int Receive(Socket socket, byte[] buffer)
    {
        try
        {
            int count = socket.Receive(buffer, 0, buffer.Length, SocketFlags.None, out SocketError error);
            return error == SocketError.Success ? count : SocketFaults.IsTimeout(error) ? -1 : 0;
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            return 0;
        }
    }

    private void SendRests()
    {
        lock (_gate)
        {
            for (int slot = 0; slot < MaxClients; slot++)
            {
                if (_clients[slot] is { } client && !client.TrySendRest()) Remove(slot);
            }
        }
    }

    private void Remove(int slot)
    {
        _clients[slot]?.Socket.Dispose();
        _clients[slot] = null;
    }

    private static void Drain(Socket socket, byte[] buffer)
    {
        while (Receive(socket, buffer) > 0)
        {
        }
    }

    private void Wake()
    {
        try
        {
            _wake.Send(WakeByte, 0, 1, SocketFlags.None, out _);
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            // Disposed, and woken before that.
        }
    }
}
