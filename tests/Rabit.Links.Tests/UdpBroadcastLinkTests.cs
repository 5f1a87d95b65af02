namespace Rabit.Links.Tests;

public sealed class UdpBroadcastLinkTests : ByteLinkContract
{
    // The calls that allocate nothing do not exist on Mono.
    protected override long AllocationLimit => System.Type.GetType("Mono.Runtime") is null ? 0 : 1000;

    protected override LinkTestBed Open()
    {
        UdpListenLink peer = UdpListenLink.Open("0.0.0.0", 0);
        UdpBroadcastLink link = UdpBroadcastLink.Open("127.255.255.255", peer.Port);
        link.Write(new byte[] { 1 }, 0, 1);
        Xunit.Assert.Equal(1, peer.Read(new byte[10], 10_000).Count);
        return new LinkPairBed(link, peer);
    }
}
