using System;
using System.Net.Sockets;
using System.Threading;

namespace Rabit.Links;

/// <summary>What the errors of sockets mean for a link, and how to say so to a user.</summary>
internal static class SocketFaults
{
    /// <summary>
    /// Errors of a datagram that say something of that datagram or of the network at the moment, not of the socket. No
    /// listener at the other end is one: the peer may not be up yet.
    /// </summary>
    public static bool PassesOnUdp(SocketError error)
        => error is SocketError.ConnectionRefused or SocketError.ConnectionReset
            or SocketError.HostUnreachable or SocketError.HostDown or SocketError.NetworkUnreachable
            or SocketError.NetworkDown
            or SocketError.NetworkReset or SocketError.NoBufferSpaceAvailable or SocketError.TimedOut
            or SocketError.WouldBlock
            or SocketError.Interrupted or SocketError.AccessDenied or SocketError.TryAgain;

    /// <summary>Errors that mean that the other end of a connection is no longer there.</summary>
    public static bool PeerGone(SocketError error)
        => error is SocketError.ConnectionReset or SocketError.ConnectionAborted
            or SocketError.Shutdown or SocketError.NotConnected or SocketError.Disconnecting
            or SocketError.NetworkReset;

    /// <summary>What a receive with a time-out says when nothing came; it depends on the runtime.</summary>
    public static bool IsTimeout(SocketError error)
        => error is SocketError.TimedOut or SocketError.WouldBlock or SocketError.TryAgain;

    /// <summary>
    /// Sets after what time a receive gives up. The present value is kept beside the socket: asking the socket, or
    /// setting it each time, would be a call of the system for every read.
    /// </summary>
    public static void SetReadTimeout(this Socket socket, int milliseconds, ref int present)
    {
        if (milliseconds == present) return;
        try
        {
            socket.ReceiveTimeout = milliseconds == Timeout.Infinite ? 0 : milliseconds;
            present = milliseconds;
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            // Closed, or broken: the receive that follows says so.
        }
    }

    /// <summary>A few words for the errors a user meets; the name of the error for the rest.</summary>
    public static string Describe(SocketError error) => error switch
    {
        SocketError.AddressAlreadyInUse => "the port is in use by another program",
        SocketError.AddressNotAvailable => "this computer does not have that address",
        SocketError.AccessDenied => "permission denied (ports below 1024 and broadcast addresses need rights)",
        SocketError.ConnectionRefused => "the host refuses the connection (nothing listens on that port)",
        SocketError.HostNotFound or SocketError.NoData => "the host is unknown",
        SocketError.TryAgain => "the name of the host cannot be looked up at the moment",
        SocketError.HostUnreachable or SocketError.HostDown => "the host cannot be reached",
        SocketError.NetworkUnreachable or SocketError.NetworkDown => "the network cannot be reached",
        SocketError.AddressFamilyNotSupported => "this computer does not support that kind of address",
        SocketError.ConnectionReset or SocketError.ConnectionAborted or SocketError.Shutdown =>
            "the remote end broke the connection",
        SocketError.TimedOut => "the remote end does not answer",
        _ => $"socket error {error}",
    };
}
