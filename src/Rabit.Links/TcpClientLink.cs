using System;
using System.Net;
using System.Net.Sockets;
using System.Threading;

namespace Rabit.Links;

/// <summary>
/// <c>tcp:HOST:PORT</c>: a connection to a TCP server, for example an autopilot in simulation. The link ends when the
/// remote end closes or breaks the connection; a remote end that only falls silent is not noticed. A write that finds
/// no room for the whole write time-out throws and counts all that was left of it as dropped, though a part may be on
/// its way; the next one may succeed.
/// </summary>
/// <example>
/// <code>
/// using TcpClientLink link = TcpClientLink.Open("127.0.0.1", 5760);   // LinkException: one line, link and reason
/// LinkRead read = link.Read(new byte[4096]);
/// </code>
/// </example>
public sealed class TcpClientLink : IByteLink
{
    private readonly Socket _socket;
    private readonly LinkLifetime _state;
    private readonly int _writeTimeoutMilliseconds;
    private readonly object _writeGate = new(); // keeps the bytes of one write together
    private int _readTimeout = Timeout.Infinite; // that of the socket; reader's thread

    private TcpClientLink(Socket socket, LinkLifetime state, int writeTimeoutMilliseconds)
    {
        _socket = socket;
        _state = state;
        _writeTimeoutMilliseconds = writeTimeoutMilliseconds;
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

    /// <summary>Connects. Tries each address of the host, IPv4 first, until one takes the connection.</summary>
    /// <param name="host">Name or address of the server.</param>
    /// <param name="port">Its port, 1 to 65535.</param>
    /// <param name="options">How long to wait for each address, and in a write; the defaults if left out.</param>
    /// <exception cref="LinkException">
    /// The host is unknown, refuses, does not answer in time, or the like; of several addresses the last one's fault.
    /// </exception>
    public static TcpClientLink Open(string host, int port, LinkOptions? options = null)
        => Open(host, port, options, new LinkStop());

    internal static TcpClientLink Open(string host, int port, LinkOptions? options, LinkStop stop)
    {
        if (host is null) throw new ArgumentNullException(nameof(host));
        if (port is < 1 or > 65535) throw new ArgumentOutOfRangeException(nameof(port), port, "a port is 1 to 65535");
        string url = LinkUrl.ForHost(LinkKind.TcpClient, host, port).ToString();
        options ??= LinkOptions.Default;
        Socket socket = TcpConnector.Connect(url, HostAddresses.Find(url, host, stop), port, options, stop);
        return new TcpClientLink(socket, new LinkLifetime(url), options.WriteTimeoutMilliseconds);
    }

    /// <inheritdoc/>
    public LinkRead Read(byte[] buffer, int timeoutMilliseconds = Timeout.Infinite)
    {
        _state.CheckRead(buffer, timeoutMilliseconds);
        _socket.SetReadTimeout(timeoutMilliseconds, ref _readTimeout);
        while (true)
        {
            if (_state.EndReason is { } reason) return LinkRead.Ended(reason);
            SocketError error = Receive(buffer, out int count);
            if (_state.EndReason is not null) continue;
            if (error == SocketError.Success && count > 0) return _state.Arrived(count);
            if (error == SocketError.Success) End("the remote end closed the connection");
            else if (timeoutMilliseconds != Timeout.Infinite && SocketFaults.IsTimeout(error))
                return LinkRead.NothingYet;
            else if (SocketFaults.PeerGone(error)) End(SocketFaults.Describe(error));
            else if (error is not (SocketError.Interrupted or SocketError.WouldBlock))
                throw Broken("cannot read", error);
        }
    }

    /// <inheritdoc/>
    public void Write(byte[] buffer, int offset, int count)
    {
        if (!_state.CheckWrite(buffer, offset, count)) return;
        lock (_writeGate)
        {
            int written = 0;
            while (written < count)
            {
                SocketError error = Send(buffer, offset + written, count - written, out int taken);
                _state.Sent(taken);
                written += taken;
                if (written < count && error is not (SocketError.Success or SocketError.Interrupted))
                    throw Lost(count - written, error);
            }
        }
    }

    /// <inheritdoc/>
    public void Unblock() => End(LinkLifetime.UnblockedReason);

    /// <inheritdoc/>
    public void SetReadableCallback(Action? callback)
    {
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        if (_state.TryDispose()) Unblock();
    }

    private SocketError Receive(byte[] buffer, out int count)
    {
        try
        {
            count = _socket.Receive(buffer, 0, buffer.Length, SocketFlags.None, out SocketError error);
            return error;
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            count = 0;
            return e is SocketException fault ? fault.SocketErrorCode : SocketError.OperationAborted;
        }
    }

    private SocketError Send(byte[] buffer, int offset, int count, out int taken)
    {
        try
        {
            taken = _socket.Send(buffer, offset, count, SocketFlags.None, out SocketError error);
            return _state.EndReason is null ? error : SocketError.OperationAborted;
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            taken = 0;
            return e is SocketException fault && _state.EndReason is null
                ? fault.SocketErrorCode
                : SocketError.OperationAborted;
        }
    }

    private LinkException Lost(int count, SocketError error)
    {
        if (_state.EndReason is null && SocketFaults.PeerGone(error)) End(SocketFaults.Describe(error));
        if (_state.EndReason is not null) return _state.DroppedByEnd(count);
        _state.Dropped(count);
        if (error is not (SocketError.TimedOut or SocketError.WouldBlock)) return Broken("cannot write", error);
        return new LinkException(
            Url, $"cannot write: the remote end took no more for {_writeTimeoutMilliseconds} ms; {count} bytes dropped",
            linkEnded: false);
    }

    private LinkException Broken(string what, SocketError error)
    {
        string reason = SocketFaults.Describe(error);
        End(reason);
        return new LinkException(Url, $"{what}: {reason}", linkEnded: true, new SocketException((int)error));
    }

    private void End(string reason)
    {
        // which ends a blocked Receive and Send, on .NET and on Mono alike
        if (_state.TryEnd(reason)) _socket.Dispose();
    }
}
