using System;
using System.Net;
using System.Net.Sockets;

namespace Rabit.Links;

/// <summary>Connects to a TCP server within a time limit.</summary>
internal static class TcpConnector
{
    public static Socket Connect(string url, IPAddress[] addresses, int port, LinkOptions options, LinkStop stop)
    {
        LinkException? fault = null;
        foreach (IPAddress address in addresses)
        {
            Socket? socket = null;
            try
            {
                socket = new Socket(address.AddressFamily, SocketType.Stream, ProtocolType.Tcp)
                {
                    // Commands are small and may not wait until there are more.
                    NoDelay = true,
                    SendTimeout = options.WriteTimeoutMilliseconds,
                };
                if (TryConnect(socket, new IPEndPoint(address, port), options.ConnectTimeout, stop)) return socket;
                fault = new LinkException(
                    url, $"the host does not answer within {options.ConnectTimeout.TotalSeconds:0.###} s",
                    linkEnded: true, mayPass: true);
            }
            catch (SocketException e)
            {
                fault = new LinkException(
                    url, $"cannot connect: {SocketFaults.Describe(e.SocketErrorCode)}", linkEnded: true, e,
                    mayPass: true);
            }

            socket?.Dispose();
        }

        throw fault!;
    }

    // A blocking Connect waits for minutes and cannot be given a limit that both runtimes keep.
    private static bool TryConnect(Socket socket, IPEndPoint server, TimeSpan limit, LinkStop stop)
    {
        IAsyncResult attempt = socket.BeginConnect(server, null, null);
        if (!stop.WaitFor(attempt.AsyncWaitHandle, limit)) return false;
        socket.EndConnect(attempt);
        return true;
    }
}
