using System;
using System.Net.Sockets;
using System.Text;

namespace Rabit.Hosting;

/// <summary>Sends notifications to a service manager, one datagram each. One thread at a time.</summary>
internal sealed class NotificationSocket : IDisposable
{
    private readonly UnixDatagramEndPoint _address;
    private readonly Socket _socket;

    /// <exception cref="FormatException">The address cannot be one.</exception>
    /// <exception cref="SocketException">There are no such sockets here.</exception>
    public NotificationSocket(string address)
    {
        _address = new UnixDatagramEndPoint(address);
        _socket = new Socket(AddressFamily.Unix, SocketType.Dgram, ProtocolType.Unspecified);
    }

    /// <exception cref="SocketException">It could not be sent.</exception>
    public void Send(string text)
    {
        byte[] bytes = Encoding.UTF8.GetBytes(text);
        _socket.SendTo(bytes, 0, bytes.Length, SocketFlags.None, _address);
    }

    public void Dispose() => _socket.Dispose();
}
