using System;
using System.Net;
using System.Net.Sockets;
using System.Threading;

namespace Rabit.Uav.Links;

/// <summary>
/// What both UDP links do: hand out the bytes of datagrams one after the other, send, and tell faults that pass from those that do not.
/// Closing the socket is what ends a blocked call, on .NET and on Mono alike.
/// </summary>
internal sealed class UdpSocket(Socket socket, LinkState state)
{
    private const int LargestDatagram = 65535;

    // A refusal answers an earlier datagram and keeps the present one from being sent: it is worth another try.
    private const int SendAttempts = 3;

    private readonly byte[] _datagram = new byte[LargestDatagram]; // reader's thread, as the two indices
    private int _next;
    private int _end;
    private EndPoint? _lastSender; // written by the reader's thread, read by writers, volatile access

    /// <summary>Who sent the last datagram; null before anybody did.</summary>
    public EndPoint? LastSender => Volatile.Read(ref _lastSender);

    public LinkRead Read(byte[] buffer)
    {
        state.CheckRead(buffer);
        while (true)
        {
            if (state.EndReason is { } reason) return LinkRead.Ended(reason);
            if (_next < _end) return state.Arrived(TakeInto(buffer));

            SocketError error = Receive();
            if (error == SocketError.Success || state.EndReason is not null) continue;
            if (!SocketFaults.PassesOnUdp(error)) throw Broken("cannot read", error);
            state.TransientFault();
        }
    }

    /// <summary>Sends one datagram to the peer the socket is connected to, or to <paramref name="receiver"/>.</summary>
    public void Write(byte[] buffer, int offset, int count, EndPoint? receiver)
    {
        SocketError error = SocketError.Success;
        for (int attempt = 0; attempt < SendAttempts; attempt++)
        {
            error = Send(buffer, offset, count, receiver);
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
        EndPoint sender = LastSender ?? AnySender();
        EndPoint before = sender;
        try
        {
            _end = socket.ReceiveFrom(_datagram, 0, _datagram.Length, SocketFlags.None, ref sender);
            _next = 0;
        }
        catch (SocketException e)
        {
            return e.SocketErrorCode;
        }
        catch (ObjectDisposedException)
        {
            return SocketError.OperationAborted;
        }

        if (!ReferenceEquals(sender, before) || LastSender is null) Volatile.Write(ref _lastSender, sender);
        return SocketError.Success;
    }

    private SocketError Send(byte[] buffer, int offset, int count, EndPoint? receiver)
    {
        try
        {
            if (receiver is not null)
            {
                socket.SendTo(buffer, offset, count, SocketFlags.None, receiver);
                return SocketError.Success;
            }

            socket.Send(buffer, offset, count, SocketFlags.None, out SocketError error);
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

    private IPEndPoint AnySender() =>
        new(socket.AddressFamily == AddressFamily.InterNetworkV6 ? IPAddress.IPv6Any : IPAddress.Any, 0);

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
