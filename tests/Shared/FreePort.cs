using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using System.Threading;

namespace Rabit.Tests.Shared;

/// <summary>
/// A port of this computer that is not in use at the moment: below those that the system gives to sockets which name
/// none, so that no connection of another test gets it before it is used. Any thread.
/// </summary>
internal static class FreePort
{
    private const int First = 20_000;
    private const int Count = 10_000;

    // Tests of one process take turns; those of another one begin elsewhere.
    private static int _turn = OwnProcessId() * 97;

    public static int Udp() => Find(SocketType.Dgram, ProtocolType.Udp);

    public static int Tcp() => Find(SocketType.Stream, ProtocolType.Tcp);

    private static int Find(SocketType type, ProtocolType protocol)
    {
        while (true)
        {
            int port = First + ((Interlocked.Increment(ref _turn) & int.MaxValue) % Count);
            using var socket = new Socket(AddressFamily.InterNetwork, type, protocol);
            try
            {
                socket.Bind(new IPEndPoint(IPAddress.Loopback, port));
                return port;
            }
            catch (SocketException)
            {
                // In use: the next one.
            }
        }
    }

    private static int OwnProcessId()
    {
        using var own = Process.GetCurrentProcess();
        return own.Id;
    }
}
