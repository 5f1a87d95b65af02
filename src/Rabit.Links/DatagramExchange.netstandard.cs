using System.Net;
using System.Net.Sockets;
using System.Threading;

namespace Rabit.Links;

/// <summary>
/// Receives datagrams from any sender and answers the last one. The twin for frameworks whose calls allocate an address
/// per datagram. One thread receives, any thread answers; <c>_lastSender</c> is replaced as a whole, never changed,
/// when the sender changes.
/// </summary>
internal sealed class DatagramExchange(Socket socket)
{
    private readonly EndPoint _anySender = new IPEndPoint(
        socket.AddressFamily == AddressFamily.InterNetworkV6 ? IPAddress.IPv6Any : IPAddress.Any, 0);

    private EndPoint? _lastSender; // volatile access

    /// <summary>Whether a datagram was received.</summary>
    public bool HasSender => Volatile.Read(ref _lastSender) is not null;

    /// <summary>Waits for a datagram.</summary>
    /// <exception cref="SocketException">As the socket says.</exception>
    public int Receive(byte[] buffer)
    {
        EndPoint sender = _lastSender ?? _anySender; // given back as it is if it is the same again
        int count = socket.ReceiveFrom(buffer, 0, buffer.Length, SocketFlags.None, ref sender);
        Volatile.Write(ref _lastSender, sender);
        return count;
    }

    /// <summary>Sends a datagram to the last sender; there must be one.</summary>
    /// <exception cref="SocketException">As the socket says.</exception>
    public void Reply(byte[] buffer, int offset, int count)
        => socket.SendTo(buffer, offset, count, SocketFlags.None, Volatile.Read(ref _lastSender)!);
}
