using System;
using System.Collections.Generic;
using System.Net;
using System.Net.Sockets;
using Xunit;

namespace Rabit.Links.Tests;

public sealed class TcpClientLinkTests : FillingLinkContract
{
    protected override string PeerGoneReason => "the remote end closed the connection";

    protected override LinkTestBed Open(LinkOptions options) => new TcpBed(options);

    [Fact]
    public void Read_PeerBreaksTheConnection_SaysSo()
    {
        using var bed = new TcpBed(LinkOptions.Default);
        var collector = new LinkCollector(bed.Link);

        bed.PeerBreaks();

        Assert.Equal("the remote end broke the connection", collector.WaitForEnd().Reason);
    }

    [Fact]
    public void Open_NoListener_SaysSo()
    {
        var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        int port = ((IPEndPoint)listener.LocalEndpoint).Port;
        listener.Stop();

        var fault = Assert.Throws<LinkException>(() => LinkFactory.Open(LinkUrl.Parse($"tcp:127.0.0.1:{port}")));

        Assert.Equal(
            $"link tcp:127.0.0.1:{port}: cannot connect: the host refuses the connection (nothing listens on that "
                + "port)",
            fault.Message);
    }

    [Fact]
    public void Open_HostDoesNotAnswer_SaysSoAfterTheTimeout()
    {
        // A listener whose queue of connections is full leaves further ones without an answer.
        using var listener = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        listener.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        listener.Listen(1);
        int port = ((IPEndPoint)listener.LocalEndPoint!).Port;
        var waiting = new List<Socket>();
        for (int i = 0; i < 8; i++)
        {
            var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
            socket.BeginConnect(IPAddress.Loopback, port, null, null);
            waiting.Add(socket);
        }

        var options = new LinkOptions(connectTimeout: TimeSpan.FromMilliseconds(200));
        LinkException fault;
        try
        {
            fault = Assert.Throws<LinkException>(() => Fill(port, options, waiting));
        }
        finally
        {
            waiting.ForEach(s => s.Dispose());
        }

        Assert.Equal($"link tcp:127.0.0.1:{port}: the host does not answer within 0.2 s", fault.Message);
    }

    [Fact]
    public void Open_UnknownHost_SaysSo() => UnknownHost.Check("tcp");

    // The queue may still take a connection or two.
    private static void Fill(int port, LinkOptions options, List<Socket> waiting)
    {
        for (int i = 0; i < 8; i++)
        {
            TcpClientLink taken = TcpClientLink.Open("127.0.0.1", port, options);
            GC.KeepAlive(taken);
        }
    }

    private sealed class TcpBed : LinkTestBed
    {
        private readonly Socket _peer;

        public TcpBed(LinkOptions options)
        {
            var listener = new TcpListener(IPAddress.Loopback, 0);
            listener.Start();
            Link = TcpClientLink.Open("127.0.0.1", ((IPEndPoint)listener.LocalEndpoint).Port, options);
            _peer = listener.AcceptSocket();
            _peer.ReceiveTimeout = (int)TestTimeout.TotalMilliseconds;
            listener.Stop();
        }

        public override IByteLink Link { get; }

        public override void PeerSends(params byte[] bytes) => _peer.Send(bytes);

        public override byte[] PeerReceives(int count)
        {
            byte[] bytes = new byte[count];
            for (int received = 0; received < count;)
            {
                int more = _peer.Receive(bytes, received, count - received, SocketFlags.None);
                Assert.NotEqual(0, more);
                received += more;
            }

            return bytes;
        }

        public override void PeerGoes() => _peer.Dispose();

        public void PeerBreaks()
        {
            _peer.LingerState = new LingerOption(true, 0);
            _peer.Dispose();
        }
    }
}
