using System.Net;
using System.Net.Sockets;
using System.Threading;

namespace Rabit.Links;

/// <summary>
/// Receives datagrams from anybody and answers whoever was heard last. Here because the calls that allocate nothing do not exist on
/// netstandard2.0. One thread receives, any thread answers; <c>_lastSender</c> is replaced as a whole, never changed, when the sender changes.
/// </summary>
internal sealed class DatagramExchange(Socket socket)
{
#if NET
    private readonly SocketAddress _sender = new(socket.AddressFamily); // receiving thread
    private SocketAddress? _lastSender; // volatile access
#else
    private readonly EndPoint _anybody = new IPEndPoint(socket.AddressFamily == AddressFamily.InterNetworkV6 ? IPAddress.IPv6Any : IPAddress.Any, 0);
    private EndPoint? _lastSender; // volatile access
#endif

    /// <summary>Whether anybody was heard.</summary>
    public bool HasSender => Volatile.Read(ref _lastSender) is not null;

    /// <summary>Waits for a datagram.</summary>
    /// <exception cref="SocketException">As the socket says.</exception>
    public int Receive(byte[] buffer)
    {
#if NET
        int count = socket.ReceiveFrom(buffer, SocketFlags.None, _sender);
        if (!_sender.Equals(_lastSender)) Volatile.Write(ref _lastSender, Copy(_sender));
#else
        EndPoint sender = _lastSender ?? _anybody; // given back as it is if it is the same again
        int count = socket.ReceiveFrom(buffer, 0, buffer.Length, SocketFlags.None, ref sender);
        Volatile.Write(ref _lastSender, sender);
#endif
        return count;
    }

    /// <summary>Sends a datagram to whoever was heard last; there must be one.</summary>
    /// <exception cref="SocketException">As the socket says.</exception>
    public void Reply(byte[] buffer, int offset, int count)
    {
#if NET
        socket.SendTo(new System.ReadOnlySpan<byte>(buffer, offset, count), SocketFlags.None, Volatile.Read(ref _lastSender)!);
#else
        socket.SendTo(buffer, offset, count, SocketFlags.None, Volatile.Read(ref _lastSender)!);
#endif
    }

#if NET
    private static SocketAddress Copy(SocketAddress address)
    {
        var copy = new SocketAddress(address.Family, address.Size);
        address.Buffer.Span.Slice(0, address.Size).CopyTo(copy.Buffer.Span);
        return copy;
    }
#endif
}
