using System;
using System.Net;
using System.Net.Sockets;
using System.Threading;
using Xunit;

namespace Rabit.Links.Tests;

public sealed class ReopeningTcpLinkTests : ReopeningLinkContract
{
    protected override string PeerGoneReason => "the remote end closed the connection";

    protected override ReopeningBed OpenBed(LinkOptions options) => new ServerBed(options);

    [Fact]
    public void Read_PeerResetsTheConnection_OpensAgain()
    {
        using var bed = new ServerBed(Quick);
        var collector = new LinkCollector(bed.Link);
        bed.ComeUp();
        bed.AwaitPeer();

        bed.PeerResets();
        bed.ComeUp();
        bed.AwaitPeer();
        bed.PeerSends(5);

        Assert.Equal(new byte[] { 5 }, collector.Take(1));
    }

    [Fact]
    public void Unblock_WhileAHostIsAsked_EndsTheReadWithin100Milliseconds()
    {
        // 192.0.2.0/24 is for documentation (RFC 5737): nothing answers there, or the network says so at once.
        using ReopeningLink link = new(
            "tcp:192.0.2.1:5760", () => TcpClientLink.Open("192.0.2.1", 5760), blocks: true, Quick);
        link.Unblock();

        Assert.Equal(LinkReadKind.Ended, link.Read(new byte[1]).Kind);
    }

    [Fact]
    public void Open_PortInUse_SaysSoAtOnce()
    {
        using UdpListenLink first = UdpListenLink.Open("127.0.0.1", 0);

        var fault = Assert.Throws<LinkException>(() => ReopeningLink.Open(LinkUrl.Parse(first.Url)));

        Assert.Contains("the port is in use by another program", fault.Message, StringComparison.Ordinal);
        Assert.False(fault.MayPass);
    }

    private sealed class ServerBed : ReopeningBed
    {
        private readonly int _port;
        private Socket? _listener;
        private Socket? _peer;

        public ServerBed(LinkOptions options)
        {
            var free = new TcpListener(IPAddress.Loopback, 0);
            free.Start();
            _port = ((IPEndPoint)free.LocalEndpoint).Port;
            free.Stop();
            Link = ReopeningLink.Open(LinkUrl.Parse($"tcp:127.0.0.1:{_port}"), options);
        }

        public override IByteLink Link { get; }

        public override void ComeUp()
        {
            _listener = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
            _listener.SetSocketOption(SocketOptionLevel.Socket, SocketOptionName.ReuseAddress, true);
            _listener.Bind(new IPEndPoint(IPAddress.Loopback, _port));
            _listener.Listen(1);
        }

        public override void AwaitPeer()
        {
            _peer = _listener!.Accept();
            _peer.ReceiveTimeout = (int)TestTimeout.TotalMilliseconds;
            _listener.Dispose();
            Await(() => Link.State == ByteLinkState.Open);
        }

        public override void PeerSends(params byte[] bytes) => _peer!.Send(bytes);

        public override byte[] PeerReceives(int count)
        {
            byte[] bytes = new byte[count];
            for (int received = 0; received < count;)
            {
                int more = _peer!.Receive(bytes, received, count - received, SocketFlags.None);
                Assert.NotEqual(0, more);
                received += more;
            }

            return bytes;
        }

        public override void PeerGoes()
        {
            _listener?.Dispose();
            _peer?.Dispose();
        }

        public void PeerResets()
        {
            _peer!.LingerState = new LingerOption(true, 0);
            PeerGoes();
        }
    }
}
