using System;
using System.Collections.Generic;
using System.Linq;
using System.Net;
using System.Net.Sockets;
using Xunit;

namespace Rabit.Links.Tests;

/// <summary>The many peers of a UDP server, the client whose host moves, and broadcast.</summary>
public sealed class UdpPeersTests
{
    [Fact]
    public void Write_SeveralPeers_GoesToAll()
    {
        using UdpListenLink link = UdpListenLink.Open("127.0.0.1", 0);
        List<UdpSendLink> peers = Peers(link, 3, out HashSet<int> numbers);

        link.Write(new byte[] { 1, 2 }, 0, 2);

        Assert.Equal(3, numbers.Count);
        Assert.All(peers, p => Assert.Equal(2, p.Read(new byte[10], 10_000).Count));
        Assert.Equal((2, 0), (link.Counters.BytesWritten, link.Counters.BytesDropped));
        peers.ForEach(p => p.Dispose());
    }

    [Fact]
    public void Read_ThousandPeers_TheLast64AreKeptAndTheOthersCounted()
    {
        using UdpListenLink link = UdpListenLink.Open("127.0.0.1", 0);
        for (int i = 0; i < 936; i++)
        {
            using UdpSendLink passing = UdpSendLink.Open("127.0.0.1", link.Port);
            passing.Write(new byte[] { 1 }, 0, 1);
            Assert.InRange(link.Read(new byte[10]).Peer, 0, 63);
        }

        List<UdpSendLink> last = Peers(link, 64, out HashSet<int> numbers);
        link.Write(new byte[] { 5 }, 0, 1);

        Assert.Equal(64, numbers.Count);
        Assert.All(last, p => Assert.Equal(1, p.Read(new byte[10], 10_000).Count));

        // A port that the system gave twice is one peer.
        Assert.InRange(link.Counters.PeersDisplaced, 900, 936);
        Assert.Equal(0, link.Counters.PeersForgotten);
        last.ForEach(p => p.Dispose());
    }

    [Fact]
    public void Open_ManyAtOnce_EachHasItsOwnPort()
    {
        // Mono shares the ports of UDP: some of 300 were equal, and each got some of the other's datagrams.
        using var server = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        server.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        var links = new List<UdpSendLink>();
        var ports = new HashSet<int>();
        for (int i = 0; i < 300; i++)
        {
            links.Add(UdpSendLink.Open("127.0.0.1", ((IPEndPoint)server.LocalEndPoint!).Port));
            links[i].Write(new byte[] { 1 }, 0, 1);
            EndPoint sender = new IPEndPoint(IPAddress.Any, 0);
            server.ReceiveFrom(new byte[10], ref sender);
            ports.Add(((IPEndPoint)sender).Port);
        }

        Assert.Equal(300, ports.Count);
        links.ForEach(l => l.Dispose());
    }

    [Fact]
    public void Write_PeerSilentForLong_ItIsForgottenAndCounted()
    {
        var clock = new ManualClock();
        using UdpListenLink link = UdpListenLink.Open(
            "127.0.0.1", 0, new LinkOptions(clock: clock, peerIdleTime: TimeSpan.FromSeconds(60)));
        List<UdpSendLink> peers = Peers(link, 2, out _);
        clock.Advance(TimeSpan.FromSeconds(40));
        peers[1].Write(new byte[] { 1 }, 0, 1);
        Assert.Equal(1, link.Read(new byte[10]).Count);
        clock.Advance(TimeSpan.FromSeconds(30));

        link.Write(new byte[] { 5 }, 0, 1);
        Assert.Equal(1, peers[1].Read(new byte[10], 10_000).Count);
        Assert.Equal(LinkReadKind.NothingYet, peers[0].Read(new byte[10], 50).Kind);
        clock.Advance(TimeSpan.FromSeconds(61));
        link.Write(new byte[] { 5 }, 0, 1);

        Assert.Equal((2L, 1L), (link.Counters.PeersForgotten, link.Counters.WritesDropped));
        peers.ForEach(p => p.Dispose());
    }

    [Fact]
    public void Client_HostMovesWhileItIsSilent_IsFoundAgain()
    {
        var clock = new ManualClock();
        using UdpListenLink first = UdpListenLink.Open("127.0.0.1", 0);
        using UdpListenLink second = UdpListenLink.Open("127.0.0.2", first.Port);
        string address = "127.0.0.1";
        int lookUps = 0;
        using UdpSendLink client = UdpSendLink.Open(
            "ground.example", first.Port, new LinkOptions(clock: clock), new LinkStop(), _ =>
            {
                lookUps++;
                return IPAddress.Parse(address);
            });
        client.Write(new byte[] { 1 }, 0, 1);
        Assert.Equal(1, first.Read(new byte[10], 10_000).Count);
        address = "127.0.0.2";

        Assert.Equal(LinkReadKind.NothingYet, client.Read(new byte[10], 20).Kind);
        Assert.Equal(1, lookUps);
        clock.Advance(TimeSpan.FromSeconds(31));
        Assert.Equal(LinkReadKind.NothingYet, client.Read(new byte[10], 20).Kind);
        client.Write(new byte[] { 2, 3 }, 0, 2);

        Assert.Equal(2, second.Read(new byte[10], 10_000).Count);
        second.Write(new byte[] { 4 }, 0, 1);
        Assert.Equal(1, client.Read(new byte[10], 10_000).Count);
        Assert.Equal(2, lookUps);
        Assert.Equal((3L, 0L), (client.Counters.BytesWritten, client.Counters.BytesDropped));
    }

    [Fact]
    public void Client_KeepAlive_SendsAnEmptyDatagramWhereNothingWasWritten()
    {
        var clock = new ManualClock();
        using var server = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        server.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        server.ReceiveTimeout = 10_000;
        int port = ((IPEndPoint)server.LocalEndPoint!).Port;
        using UdpSendLink client = UdpSendLink.Open(
            "127.0.0.1", port, new LinkOptions(clock: clock, keepAlive: TimeSpan.FromSeconds(5)));

        clock.Advance(TimeSpan.FromSeconds(4));
        client.Write(new byte[] { 9 }, 0, 1);
        clock.Advance(TimeSpan.FromSeconds(4));
        client.Read(new byte[10], 5);
        clock.Advance(TimeSpan.FromSeconds(2));
        client.Read(new byte[10], 5);
        client.Read(new byte[10], 5);

        Assert.Equal((1, 0, 0), (server.Receive(new byte[10]), server.Receive(new byte[10]), server.Available));
    }

    [Fact]
    public void Broadcast_AllWhoListen_HearItAndCanAnswer()
    {
        using UdpListenLink one = UdpListenLink.Open("0.0.0.0", 0);
        using UdpBroadcastLink link = UdpBroadcastLink.Open("127.255.255.255", one.Port);

        link.Write(new byte[] { 1, 2, 3 }, 0, 3);
        Assert.Equal(3, one.Read(new byte[10], 10_000).Count);
        one.Write(new byte[] { 4 }, 0, 1);

        Assert.Equal(1, link.Read(new byte[10], 10_000).Count);
        Assert.Equal((3L, 0L), (link.Counters.BytesWritten, link.Counters.BytesDropped));
        Assert.Equal($"udpbcast:127.255.255.255:{one.Port}", link.Url);
    }

    [Theory]
    [InlineData("::1")]
    [InlineData("ground.example")]
    public void Broadcast_NoAddressOfIpv4_SaysSo(string address)
        => Assert.Contains(
            $"'{address}' is not a broadcast address of IPv4",
            Assert.Throws<LinkException>(() => UdpBroadcastLink.Open(address, 14550)).Message,
            StringComparison.Ordinal);

    private static List<UdpSendLink> Peers(UdpListenLink link, int count, out HashSet<int> numbers)
    {
        numbers = [];
        var peers = Enumerable.Range(0, count).Select(_ => UdpSendLink.Open("127.0.0.1", link.Port)).ToList();
        foreach (UdpSendLink peer in peers)
        {
            peer.Write(new byte[] { 1 }, 0, 1);
            LinkRead read = link.Read(new byte[10], 10_000);
            Assert.Equal(1, read.Count);
            numbers.Add(read.Peer);
        }

        return peers;
    }

    internal sealed class ManualClock : TimeProvider
    {
        private long _ticks = 1;

        public override long TimestampFrequency => TimeSpan.TicksPerSecond;

        public override long GetTimestamp() => _ticks;

        public void Advance(TimeSpan time) => _ticks += time.Ticks;
    }
}
