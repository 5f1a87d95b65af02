using System;
using System.Net;
using System.Net.Sockets;

namespace Rabit.Links;

/// <summary>
/// Receives datagrams from any sender and answers all of them, or one address. Its calls allocate nothing;
/// netstandard2.0, which lacks them, has a twin. One thread receives, any thread answers.
/// </summary>
/// <param name="socket">Bound.</param>
/// <param name="peers">Those from whom something was received.</param>
/// <param name="target">Where all is sent to; null for to all peers.</param>
internal sealed class DatagramExchange(Socket socket, PeerTable<SocketAddress> peers, IPEndPoint? target = null)
{
    private static readonly Func<SocketAddress, SocketAddress> Copy = CopyOf;

    private readonly SocketAddress _sender = new(socket.AddressFamily); // receiving thread
    private readonly SocketAddress? _target = target?.Serialize();
    private readonly object _sendGate = new();
    private readonly SocketAddress[] _receivers = new SocketAddress[PeerTable<SocketAddress>.MaxPeers]; // _sendGate

    public static DatagramExchange Create(
        Socket socket, LinkLifetime state, LinkOptions options, IPEndPoint? target = null)
        => new(socket, new PeerTable<SocketAddress>(state, options.PeerIdleTime, options.Clock), target);

    /// <summary>Waits for a datagram.</summary>
    /// <exception cref="SocketException">As the socket says.</exception>
    public int Receive(byte[] buffer, out int peer)
    {
        int count = socket.ReceiveFrom(buffer, SocketFlags.None, _sender);
        peer = peers.Note(_sender, Copy);
        return count;
    }

    /// <summary>
    /// Sends a datagram to each, but to none where there are too many. Gives to how many it went, and what the last one
    /// that failed said.
    /// </summary>
    public int SendToAll(byte[] buffer, int offset, int count, int maxReceivers, out SocketError fault)
    {
        fault = SocketError.Success;
        lock (_sendGate)
        {
            int receivers = 1;
            if (_target is not null) _receivers[0] = _target;
            else receivers = peers.CopyTo(_receivers);
            if (receivers > maxReceivers)
            {
                fault = SocketError.WouldBlock;
                return 0;
            }

            int sent = 0;
            for (int i = 0; i < receivers; i++)
            {
                try
                {
                    socket.SendTo(new ReadOnlySpan<byte>(buffer, offset, count), SocketFlags.None, _receivers[i]);
                    sent++;
                }
                catch (SocketException e)
                {
                    fault = e.SocketErrorCode;
                }
            }

            return sent;
        }
    }

    private static SocketAddress CopyOf(SocketAddress address)
    {
        var copy = new SocketAddress(address.Family, address.Size);
        address.Buffer.Span.Slice(0, address.Size).CopyTo(copy.Buffer.Span);
        return copy;
    }
}
