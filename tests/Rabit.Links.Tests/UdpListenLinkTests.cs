using System;
using System.Net;
using System.Net.Sockets;
using Xunit;

namespace Rabit.Links.Tests;

public sealed class UdpListenLinkTests : ByteLinkContract
{
    // The calls that allocate nothing do not exist on Mono; 376 bytes were measured there.
    protected override long AllocationLimit => Type.GetType("Mono.Runtime") is null ? 0 : 700;

    protected override LinkTestBed Open()
    {
        UdpListenLink link = UdpListenLink.Open("127.0.0.1", 0);
        UdpSendLink peer = UdpSendLink.Open("127.0.0.1", link.Port);
        peer.Write(new byte[] { 1 }, 0, 1);
        Assert.Equal(1, link.Read(new byte[10]).Count);
        return new LinkPairBed(link, peer);
    }

    [Fact]
    public void Open_AnyPort_UrlNamesTheOneItGot()
    {
        using UdpListenLink link = UdpListenLink.Open("127.0.0.1", 0);

        Assert.InRange(link.Port, 1, 65535);
        Assert.Equal($"udpin:127.0.0.1:{link.Port}", link.Url);
    }

    [Fact]
    public void Open_PortInUse_SaysSo()
    {
        using UdpListenLink first = UdpListenLink.Open("127.0.0.1", 0);

        var fault = Assert.Throws<LinkException>(() => LinkFactory.Open(LinkUrl.Parse(first.Url)));

        Assert.Equal($"link {first.Url}: cannot listen: the port is in use by another program", fault.Message);
        Assert.True(fault.LinkEnded);
    }

    [Fact]
    public void Open_PortOfAClosedLink_IsFree()
    {
        UdpListenLink first = UdpListenLink.Open("127.0.0.1", 0);
        first.Dispose();

        using IByteLink second = LinkFactory.Open(LinkUrl.Parse(first.Url));

        Assert.Equal(first.Url, second.Url);
    }

    [Fact]
    public void Open_AddressOfAnotherComputer_SaysSo()
    {
        // 192.0.2.0/24 is for documentation (RFC 5737): no host has it.
        var fault = Assert.Throws<LinkException>(() => UdpListenLink.Open("192.0.2.1", 14550));

        Assert.Equal(
            "link udpin:192.0.2.1:14550: cannot listen: this computer does not have that address", fault.Message);
    }

    [Fact]
    public void Write_BeforeAPeerIsKnown_IsDroppedAndCounted()
    {
        using UdpListenLink link = UdpListenLink.Open("127.0.0.1", 0);

        link.Write(new byte[7], 0, 7);

        Assert.Equal((0, 7, 1), (link.Counters.BytesWritten, link.Counters.BytesDropped, link.Counters.WritesDropped));
    }

    [Fact]
    public void Write_TwoSenders_GoesToBoth()
    {
        using UdpListenLink link = UdpListenLink.Open("127.0.0.1", 0);
        using UdpSendLink first = UdpSendLink.Open("127.0.0.1", link.Port);
        using UdpSendLink second = UdpSendLink.Open("127.0.0.1", link.Port);
        byte[] buffer = new byte[10];

        byte reply = 0;
        foreach (UdpSendLink sender in new[] { first, second, first })
        {
            sender.Write(new byte[] { 1 }, 0, 1);
            Assert.Equal(1, link.Read(buffer).Count);
            link.Write(new[] { ++reply }, 0, 1);
            Assert.Equal(1, sender.Read(buffer).Count);
            Assert.Equal(reply, buffer[0]);
            if (reply == 1) continue; // the second has not sent yet
            UdpSendLink other = ReferenceEquals(sender, first) ? second : first;
            Assert.Equal(1, other.Read(buffer).Count);
            Assert.Equal(reply, buffer[0]);
        }
    }

    [Fact]
    public void Read_SenderWithoutListener_DoesNotEndTheLink()
    {
        using UdpListenLink link = UdpListenLink.Open("127.0.0.1", 0);
        byte[] buffer = new byte[10];
        using (UdpSendLink gone = UdpSendLink.Open("127.0.0.1", link.Port)) gone.Write(new byte[1], 0, 1);
        Assert.Equal(1, link.Read(buffer).Count);
        // to a closed port: the network answers each with a refusal
        for (int i = 0; i < 5; i++) link.Write(new byte[3], 0, 3);

        using UdpSendLink next = UdpSendLink.Open("127.0.0.1", link.Port);
        next.Write(new byte[2], 0, 2);

        Assert.Equal(2, link.Read(buffer).Count);
    }

    [Fact]
    public void Read_EmptyDatagram_IsPassedOver()
    {
        using UdpListenLink link = UdpListenLink.Open("127.0.0.1", 0);
        using var sender = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        var target = new IPEndPoint(IPAddress.Loopback, link.Port);

        sender.SendTo(Array.Empty<byte>(), target);
        sender.SendTo(new byte[] { 1, 2 }, target);

        Assert.Equal(2, link.Read(new byte[10]).Count);
    }

    [Fact]
    public void Read_MaxDatagramThroughASmallBuffer_LosesNothing()
    {
        using UdpListenLink link = UdpListenLink.Open("127.0.0.1", 0);
        using UdpSendLink sender = UdpSendLink.Open("127.0.0.1", link.Port);

        sender.Write(new byte[65507], 0, 65507);

        var collector = new LinkCollector(link, bufferBytes: 1000);
        Assert.Equal(65507, collector.Take(65507).Length);
    }
}
