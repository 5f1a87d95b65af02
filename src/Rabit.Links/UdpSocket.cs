using System;
using System.Net.Sockets;
using System.Threading;

namespace Rabit.Links;

/// <summary>
/// What both UDP links do: hand out the bytes of datagrams one after the other, send, and distinguish faults that pass
/// from those that do not. Closing the socket is what ends a blocked call, on .NET and on Mono alike.
/// </summary>
/// <param name="socket">Bound or connected.</param>
/// <param name="state">The state of the link.</param>
/// <param name="exchange">For a socket without one peer; null if it is connected to its peer.</param>
internal sealed class UdpSocket(Socket socket, LinkLifetime state, DatagramExchange? exchange)
{
    private const int MaxDatagram = 65535;

    // A refusal answers an earlier datagram and keeps the present one from being sent: it is worth another try.
    private const int SendAttempts = 3;

    // So many that their datagrams fit into the part of the buffer that is free where a socket is writable, and that
    // sending to them takes less time than a wake-up of another thread.
    private const int FewReceivers = 4;

    // No error of a socket: there is none to send to yet.
    private const SocketError NoPeer = SocketError.NotConnected;

    // Mono sends no empty array; an empty part of one it does.
    private static readonly ArraySegment<byte>[] Nothing = [new ArraySegment<byte>(new byte[1], 0, 0)];

    private readonly byte[] _datagram = new byte[MaxDatagram]; // reader's thread, as the two indices
    private int _next;
    private int _end;
    private int _peer; // whose datagram it is
    private int _isRetired; // volatile access
    private int _timeout = Timeout.Infinite; // that of the socket

    /// <summary>
    /// A socket for datagrams that has its port to itself. By default two sockets may share one on Mono, also where the
    /// system chooses it, and each then gets some of the datagrams.
    /// </summary>
    public static Socket Create(AddressFamily family)
    {
        var socket = new Socket(family, SocketType.Dgram, ProtocolType.Udp);
        socket.SetSocketOption(SocketOptionLevel.Socket, SocketOptionName.ReuseAddress, false);
        return socket;
    }

    public LinkRead Read(byte[] buffer, int timeoutMilliseconds)
    {
        state.CheckRead(buffer, timeoutMilliseconds);
        socket.SetReadTimeout(timeoutMilliseconds, ref _timeout);
        while (true)
        {
            if (state.EndReason is { } reason) return LinkRead.Ended(reason);
            if (_next < _end) return state.Arrived(TakeInto(buffer), _peer);

            SocketError error = Receive();
            if (error == SocketError.Success || state.EndReason is not null) continue;
            if (Volatile.Read(ref _isRetired) != 0) return LinkRead.NothingYet;
            if (SocketFaults.IsTimeout(error) && timeoutMilliseconds != Timeout.Infinite) return LinkRead.NothingYet;
            if (!SocketFaults.PassesOnUdp(error)) throw Broken("cannot read", error);
            state.TransientFault();
        }
    }

    /// <summary>Sends one datagram to the peer, or to all of them; where there is none it is dropped.</summary>
    public void Write(byte[] buffer, int offset, int count)
    {
        SocketError error = SocketError.Success;
        for (int attempt = 0; attempt < SendAttempts; attempt++)
        {
            error = Send(buffer, offset, count);
            if (error == SocketError.Success)
            {
                state.Sent(count);
                return;
            }

            if (state.EndReason is not null) throw state.DroppedByEnd(count);
            if (Volatile.Read(ref _isRetired) != 0 || error == NoPeer) break;
            if (SocketFaults.PassesOnUdp(error)) state.TransientFault();
            if (error != SocketError.ConnectionRefused) break;
        }

        state.Dropped(count);
        if (error == NoPeer || SocketFaults.PassesOnUdp(error) || Volatile.Read(ref _isRetired) != 0) return;
        if (error != SocketError.MessageSize) throw Broken("cannot write", error);
        throw new LinkException(state.Url, $"{count} bytes do not fit into one datagram; dropped", linkEnded: false);
    }

    /// <summary>
    /// Sends one datagram to the peer, or to all of a few, if the socket has room for it now. False where it did not.
    /// </summary>
    public bool TryWrite(byte[] buffer, int offset, int count)
    {
        if (state.EndReason is not null || Volatile.Read(ref _isRetired) != 0 || !IsWritable()) return false;
        SocketError error = Send(buffer, offset, count, FewReceivers);
        if (error == SocketError.Success)
        {
            state.Sent(count);
            return true;
        }

        if (error is not (NoPeer or SocketError.WouldBlock) && SocketFaults.PassesOnUdp(error)) state.TransientFault();
        return false;
    }

    /// <summary>Sends an empty datagram, which keeps the way through address translation open.</summary>
    public void KeepAlive()
    {
        if (Send([], 0, 0) is var error && error != SocketError.Success) state.TransientFault();
    }

    /// <summary>
    /// Closes the socket without ending the link, which has another one. Bytes that it still holds are lost.
    /// </summary>
    public void Retire()
    {
        Volatile.Write(ref _isRetired, 1);
        socket.Dispose();
    }

    public void End(string reason)
    {
        if (state.TryEnd(reason)) Close();
    }

    /// <summary>Closes the socket, which ends what waits for it.</summary>
    public void Close() => socket.Dispose();

    private SocketError Receive()
    {
        try
        {
            SocketError error = SocketError.Success;
            int count = exchange?.Receive(_datagram, out _peer)
                ?? socket.Receive(_datagram, 0, _datagram.Length, SocketFlags.None, out error);
            if (error != SocketError.Success) return error;
            _next = 0;
            _end = count;
            return SocketError.Success;
        }
        catch (SocketException e)
        {
            return e.SocketErrorCode;
        }
        catch (ObjectDisposedException)
        {
            return SocketError.OperationAborted;
        }
    }

    // Linux says so while half of the buffer is free, which is more than a few datagrams of frames need.
    private bool IsWritable()
    {
        try
        {
            return socket.Poll(0, SelectMode.SelectWrite);
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            return false;
        }
    }

    private SocketError Send(byte[] buffer, int offset, int count, int maxReceivers = int.MaxValue)
    {
        try
        {
            SocketError error = SocketError.Success;
            if (exchange is null && count == 0) socket.Send(Nothing, SocketFlags.None, out error);
            else if (exchange is null) socket.Send(buffer, offset, count, SocketFlags.None, out error);
            else if (exchange.SendToAll(buffer, offset, count, maxReceivers, out error) > 0) return SocketError.Success;
            else if (error == SocketError.Success) return NoPeer;
            return error;
        }
        catch (SocketException e)
        {
            return e.SocketErrorCode;
        }
        catch (ObjectDisposedException)
        {
            return SocketError.OperationAborted;
        }
    }

    private int TakeInto(byte[] buffer)
    {
        int count = Math.Min(buffer.Length, _end - _next);
        Buffer.BlockCopy(_datagram, _next, buffer, 0, count);
        _next += count;
        return count;
    }

    private LinkException Broken(string what, SocketError error)
    {
        string reason = SocketFaults.Describe(error);
        End(reason);
        return new LinkException(state.Url, $"{what}: {reason}", linkEnded: true, new SocketException((int)error));
    }
}
