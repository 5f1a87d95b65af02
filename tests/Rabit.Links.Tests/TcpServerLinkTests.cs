using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Net.Sockets;
using System.Threading;
using Xunit;

namespace Rabit.Links.Tests;

public sealed class TcpServerLinkTests : ByteLinkContract
{
    // Asking the system which of the clients has bytes allocates a list.
    protected override long AllocationLimit => 4096;

    protected override LinkTestBed Open()
    {
        TcpServerLink link = TcpServerLink.Open("127.0.0.1", 0);
        TcpClientLink peer = TcpClientLink.Open("127.0.0.1", link.Port);
        AwaitClients(link, 1);
        return new LinkPairBed(link, peer);
    }

    [Fact]
    public void Open_AnyPort_UrlNamesTheOneItGot()
    {
        using TcpServerLink link = TcpServerLink.Open("127.0.0.1", 0);

        Assert.Equal($"tcpin:127.0.0.1:{link.Port}", link.Url);
        Assert.Equal(LinkKind.TcpServer, LinkUrl.Parse(link.Url).Kind);
    }

    [Fact]
    public void Open_PortInUse_SaysSo()
    {
        using TcpServerLink first = TcpServerLink.Open("127.0.0.1", 0);

        var fault = Assert.Throws<LinkException>(() => LinkFactory.Open(LinkUrl.Parse(first.Url)));

        Assert.Equal($"link {first.Url}: cannot listen: the port is in use by another program", fault.Message);
    }

    [Fact]
    public void Open_PortOfAClosedLinkThatHadAClient_IsFree()
    {
        TcpServerLink first = TcpServerLink.Open("127.0.0.1", 0);
        using TcpClientLink client = TcpClientLink.Open("127.0.0.1", first.Port);
        AwaitClients(first, 1);
        first.Dispose();

        using IByteLink second = LinkFactory.Open(LinkUrl.Parse(first.Url));

        Assert.Equal(first.Url, second.Url);
    }

    [Fact]
    public void ReadAndWrite_SeveralClients_ComeWithTheirNumbersAndAllAreAnswered()
    {
        using TcpServerLink link = TcpServerLink.Open("127.0.0.1", 0);
        TcpClientLink[] clients =
            Enumerable.Range(0, 3).Select(_ => TcpClientLink.Open("127.0.0.1", link.Port)).ToArray();
        AwaitClients(link, 3);
        byte[] buffer = new byte[10];
        var peers = new HashSet<int>();
        foreach (TcpClientLink client in clients)
        {
            client.Write(new byte[] { 1 }, 0, 1);
            LinkRead read = link.Read(buffer);
            Assert.Equal(1, read.Count);
            peers.Add(read.Peer);
        }

        link.Write(new byte[] { 7, 8 }, 0, 2);

        Assert.Equal(3, peers.Count);
        Assert.All(clients, c => Assert.Equal(2, c.Read(new byte[10]).Count));
        Assert.Equal(2, link.Counters.BytesWritten);
        Array.ForEach(clients, c => c.Dispose());
    }

    [Fact]
    public void Read_ClientGoesAndAnotherComes_GoesOn()
    {
        using TcpServerLink link = TcpServerLink.Open("127.0.0.1", 0);
        var collector = new LinkCollector(link);
        for (byte cycle = 0; cycle < 5; cycle++)
        {
            using TcpClientLink client = TcpClientLink.Open("127.0.0.1", link.Port);
            client.Write(new[] { cycle }, 0, 1);
            Assert.Equal(new[] { cycle }, collector.Take(1));
        }

        Assert.Equal(ByteLinkState.Open, link.State);
    }

    [Fact]
    public void Write_OneClientNeverReads_TheOtherGetsAllAndNoWriteWaits()
    {
        using TcpServerLink link = TcpServerLink.Open("127.0.0.1", 0);
        var reading = new LinkCollector(link);
        using var stalled = new TcpClient("127.0.0.1", link.Port);
        using TcpClientLink other = TcpClientLink.Open("127.0.0.1", link.Port);
        var collector = new LinkCollector(other, bufferBytes: 65536);
        AwaitClients(link, 2, isRead: true);
        byte[] chunk = new byte[50_000];
        TimeSpan longest = TimeSpan.Zero;
        for (int i = 0; i < 400; i++)
        {
            for (int b = 0; b < chunk.Length; b++) chunk[b] = (byte)(i + b);
            var watch = Stopwatch.StartNew();
            link.Write(chunk, 0, chunk.Length);
            if (watch.Elapsed > longest) longest = watch.Elapsed;
            Assert.Equal(chunk, collector.Take(chunk.Length));
        }

        Assert.InRange(longest, TimeSpan.Zero, TimeSpan.FromMilliseconds(500));
        Assert.Equal((400L * chunk.Length, 0L), (link.Counters.BytesWritten, link.Counters.BytesDropped));
        Assert.False(reading.EndsWithin(TimeSpan.Zero));
    }

    [Fact]
    public void Write_OnlyClientNeverReads_IsDroppedAndCountedAsAWhole()
    {
        using TcpServerLink link = TcpServerLink.Open("127.0.0.1", 0);
        using var stalled = new TcpClient("127.0.0.1", link.Port);
        AwaitClients(link, 1);
        for (int i = 0; i < 500; i++) link.Write(new byte[50_000], 0, 50_000);

        LinkCounters counters = link.Counters;
        Assert.Equal(500L * 50_000, counters.BytesWritten + counters.BytesDropped);
        Assert.Equal(counters.WritesDropped * 50_000, counters.BytesDropped);
        Assert.NotEqual(0, counters.WritesDropped);
    }

    [Fact]
    public void Accept_MoreClientsThanThereMayBe_TheOneSilentLongestGoes()
    {
        using TcpServerLink link = TcpServerLink.Open("127.0.0.1", 0);
        var collector = new LinkCollector(link);
        var clients = new List<TcpClientLink>();
        for (int i = 0; i <= TcpServerLink.MaxClients; i++)
        {
            clients.Add(TcpClientLink.Open("127.0.0.1", link.Port));
            clients[i].Write(new byte[] { 1 }, 0, 1);
            collector.Take(1);
        }

        Assert.Equal(LinkReadKind.Ended, clients[0].Read(new byte[1], 10_000).Kind);
        Assert.Equal((TcpServerLink.MaxClients, 1L), (link.Clients, link.Counters.PeersDisplaced));
        clients.ForEach(c => c.Dispose());
    }

    [Fact]
    public void Write_WithoutAClient_IsDroppedAndCounted()
    {
        using TcpServerLink link = TcpServerLink.Open("127.0.0.1", 0);

        link.Write(new byte[7], 0, 7);

        Assert.Equal((0, 7, 1), (link.Counters.BytesWritten, link.Counters.BytesDropped, link.Counters.WritesDropped));
    }

    private static void AwaitClients(TcpServerLink link, int count, bool isRead = false)
    {
        var watch = Stopwatch.StartNew();
        while (link.Clients < count)
        {
            if (isRead) Thread.Sleep(1);
            else Assert.Equal(LinkReadKind.NothingYet, link.Read(new byte[1], 1).Kind);
            Assert.InRange(watch.Elapsed, TimeSpan.Zero, LinkTestBed.TestTimeout);
        }
    }
}
