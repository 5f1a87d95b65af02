using System;
using System.Net;
using System.Net.Sockets;
using System.Threading;

namespace Rabit.Links;

/// <summary>Finds the addresses of a host.</summary>
internal static class HostAddresses
{
    /// <summary>
    /// The addresses of a host, IPv4 before IPv6: over UDP it cannot be known which one is listened on, and MAVLink
    /// programs listen on IPv4. Waits for the system's name service as long as that takes.
    /// </summary>
    /// <exception cref="LinkException">The name is not known.</exception>
    /// <remarks>A stop ends the wait; the look-up itself, which cannot be ended, is left to itself.</remarks>
    public static IPAddress[] Find(string url, string host, LinkStop stop)
        => Find(url, host, stop, static name => Dns.BeginGetHostAddresses(name, null, null));

    /// <summary>The same with a name service of the caller's; its answer is not read where a stop is first.</summary>
    internal static IPAddress[] Find(string url, string host, LinkStop stop, Func<string, IAsyncResult> ask)
    {
        if (IPAddress.TryParse(host, out IPAddress? literal)) return [literal];

        IPAddress[] found;
        try
        {
            IAsyncResult lookUp = ask(host);
            if (!stop.WaitFor(lookUp.AsyncWaitHandle, Timeout.InfiniteTimeSpan))
                throw new LinkException(url, LinkLifetime.UnblockedReason, linkEnded: true, mayPass: true);
            found = Dns.EndGetHostAddresses(lookUp);
        }
        catch (SocketException e)
        {
            throw new LinkException(url, SocketFaults.Describe(e.SocketErrorCode), linkEnded: true, e,
                mayPass: e.SocketErrorCode == SocketError.TryAgain);
        }
        catch (ArgumentException e)
        {
            throw new LinkException(url, $"'{host}' cannot be the name of a host", linkEnded: true, e);
        }

        if (found.Length == 0) throw new LinkException(url, SocketFaults.Describe(SocketError.NoData), linkEnded: true);
        Array.Sort(found, (x, y) => IsIpv6(x).CompareTo(IsIpv6(y)));
        return found;
    }

    private static bool IsIpv6(IPAddress address) => address.AddressFamily == AddressFamily.InterNetworkV6;
}
