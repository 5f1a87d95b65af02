using System;
using System.Net;
using System.Net.Sockets;
using System.Threading;

namespace Rabit.Links;

/// <summary>
/// Receives datagrams from any sender and answers the last one. Its calls allocate nothing; netstandard2.0, which lacks
/// them, has a twin. One thread receives, any thread answers; <c>_lastSender</c> is replaced as a whole, never changed,
/// when the sender changes.
/// </summary>
internal sealed class DatagramExchange(Socket socket)
{
    private readonly SocketAddress _sender = new(socket.AddressFamily); // receiving thread
    private SocketAddress? _lastSender; // volatile access

    /// <summary>Whether a datagram was received.</summary>
    public bool HasSender => Volatile.Read(ref _lastSender) is not null;

    /// <summary>Waits for a datagram.</summary>
    /// <exception cref="SocketException">As the socket says.</exception>
    public int Receive(byte[] buffer)
    {
        int count = socket.ReceiveFrom(buffer, SocketFlags.None, _sender);
        if (!_sender.Equals(_lastSender)) Volatile.Write(ref _lastSender, Copy(_sender));
        return count;
    }

    /// <summary>Sends a datagram to the last sender; there must be one.</summary>
    /// <exception cref="SocketException">As the socket says.</exception>
    public void Reply(byte[] buffer, int offset, int count)
        => socket.SendTo(
            new ReadOnlySpan<byte>(buffer, offset, count), SocketFlags.None, Volatile.Read(ref _lastSender)!);

    private static SocketAddress Copy(SocketAddress address)
    {
        var copy = new SocketAddress(address.Family, address.Size);
        address.Buffer.Span.Slice(0, address.Size).CopyTo(copy.Buffer.Span);
        return copy;
    }
}
