using System;
using System.Net;
using System.Net.Sockets;

namespace Rabit.Links;

/// <summary>
/// Receives datagrams from any sender and answers all of them, or one address. The twin for frameworks whose calls
/// allocate an address per datagram. One thread receives, any thread answers.
/// </summary>
/// <param name="socket">Bound.</param>
/// <param name="peers">Those from whom something was received.</param>
/// <param name="target">Where all is sent to; null for to all peers.</param>
internal sealed class DatagramExchange(Socket socket, PeerTable<EndPoint> peers, IPEndPoint? target = null)
{
    private static readonly Func<EndPoint, EndPoint> Same = address => address; // each datagram has its own

    private readonly EndPoint _anySender = new IPEndPoint(
        socket.AddressFamily == AddressFamily.InterNetworkV6 ? IPAddress.IPv6Any : IPAddress.Any, 0);

    private readonly object _sendGate = new();
    private readonly EndPoint[] _receivers = new EndPoint[PeerTable<EndPoint>.MaxPeers]; // guarded by _sendGate

    public static DatagramExchange Create(
        Socket socket, LinkLifetime state, LinkOptions options, IPEndPoint? target = null)
        => new(socket, new PeerTable<EndPoint>(state, options.PeerIdleTime, options.Clock), target);

    /// <summary>Waits for a datagram.</summary>
    /// <exception cref="SocketException">As the socket says.</exception>
    public int Receive(byte[] buffer, out int peer)
    {
        EndPoint sender = _anySender;
        int count = socket.ReceiveFrom(buffer, 0, buffer.Length, SocketFlags.None, ref sender);
        peer = peers.Note(sender, Same);
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
            if (target is not null) _receivers[0] = target;
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
                    socket.SendTo(buffer, offset, count, SocketFlags.None, _receivers[i]);
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
}
