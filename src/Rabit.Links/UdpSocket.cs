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

    private readonly byte[] _datagram = new byte[MaxDatagram]; // reader's thread, as the two indices
    private int _next;
    private int _end;
    private int _timeout = Timeout.Infinite; // that of the socket

    public LinkRead Read(byte[] buffer, int timeoutMilliseconds)
    {
        state.CheckRead(buffer, timeoutMilliseconds);
        socket.SetReadTimeout(timeoutMilliseconds, ref _timeout);
        while (true)
        {
            if (state.EndReason is { } reason) return LinkRead.Ended(reason);
            if (_next < _end) return state.Arrived(TakeInto(buffer));

            SocketError error = Receive();
            if (error == SocketError.Success || state.EndReason is not null) continue;
            if (SocketFaults.IsTimeout(error) && timeoutMilliseconds != Timeout.Infinite) return LinkRead.NothingYet;
            if (!SocketFaults.PassesOnUdp(error)) throw Broken("cannot read", error);
            state.TransientFault();
        }
    }

    /// <summary>Sends one datagram to the peer, or to the last sender; there must be one.</summary>
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
            if (SocketFaults.PassesOnUdp(error)) state.TransientFault();
            if (error != SocketError.ConnectionRefused) break;
        }

        state.Dropped(count);
        if (SocketFaults.PassesOnUdp(error)) return;
        if (error != SocketError.MessageSize) throw Broken("cannot write", error);
        throw new LinkException(state.Url, $"{count} bytes do not fit into one datagram; dropped", linkEnded: false);
    }

    public void End(string reason)
    {
        if (state.TryEnd(reason)) socket.Dispose();
    }

    private SocketError Receive()
    {
        try
        {
            SocketError error = SocketError.Success;
            int count = exchange?.Receive(_datagram)
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

    private SocketError Send(byte[] buffer, int offset, int count)
    {
        try
        {
            SocketError error = SocketError.Success;
            if (exchange is not null) exchange.Reply(buffer, offset, count);
            else socket.Send(buffer, offset, count, SocketFlags.None, out error);
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
