using System;
using Xunit;

namespace Rabit.Links.Tests;

public sealed class UdpSendLinkTests : ByteLinkContract
{
    protected override LinkTestBed Open()
    {
        UdpListenLink peer = UdpListenLink.Open("127.0.0.1", 0);
        UdpSendLink link = UdpSendLink.Open("127.0.0.1", peer.Port);
        link.Write(new byte[] { 1 }, 0, 1);
        Assert.Equal(1, peer.Read(new byte[10]).Count);
        return new LinkPairBed(link, peer);
    }

    [Fact]
    public void ReadAndWrite_PeerComesUpLater_GoOn()
    {
        UdpListenLink placeHolder = UdpListenLink.Open("127.0.0.1", 0);
        placeHolder.Dispose();
        using UdpSendLink link = UdpSendLink.Open("127.0.0.1", placeHolder.Port);
        var collector = new LinkCollector(link);
        for (int i = 0; i < 10; i++) link.Write(new byte[3], 0, 3);
        Assert.False(collector.EndsWithin(TimeSpan.FromMilliseconds(20)));

        using UdpListenLink peer = UdpListenLink.Open("127.0.0.1", placeHolder.Port);
        link.Write(new byte[] { 1, 2 }, 0, 2);
        Assert.Equal(2, peer.Read(new byte[10]).Count);
        peer.Write(new byte[] { 7 }, 0, 1);

        Assert.Equal(new byte[] { 7 }, collector.Take(1));
        Assert.Equal(32, link.Counters.BytesWritten + link.Counters.BytesDropped);
        Assert.InRange(link.Counters.TransientFaults, 1, 30);
    }

    [Fact]
    public void Write_MoreThanADatagram_ThrowsAndTheLinkGoesOn()
    {
        using LinkTestBed bed = Open();

        var fault = Assert.Throws<LinkException>(() => bed.Link.Write(new byte[70_000], 0, 70_000));

        Assert.Equal($"link {bed.Link.Url}: 70000 bytes do not fit into one datagram; dropped", fault.Message);
        Assert.False(fault.LinkEnded);
        Assert.Equal((70_000, 1), (bed.Link.Counters.BytesDropped, bed.Link.Counters.WritesDropped));
        bed.Link.Write(new byte[] { 9 }, 0, 1);
        Assert.Equal(new byte[] { 9 }, bed.PeerReceives(1));
    }

    [Fact]
    public void Open_UnknownHost_SaysSo() => UnknownHost.Check("udpout");

    [Theory]
    [InlineData(0)]
    [InlineData(65536)]
    public void Open_BadPort_Throws(int port) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => UdpSendLink.Open("127.0.0.1", port));
}
