using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Links.Tests;

/// <summary>What <see cref="INonBlockingWriter"/> promises, for every link that is one.</summary>
public sealed class NonBlockingWriterTests
{
    private static readonly Dictionary<string, Func<LinkTestBed>> Beds = new()
    {
        ["udpout"] = () =>
        {
            UdpListenLink peer = UdpListenLink.Open("127.0.0.1", 0);
            return new LinkPairBed(UdpSendLink.Open("127.0.0.1", peer.Port), peer);
        },
        ["udpin"] = () => ToOnePeer(UdpListenLink.Open("127.0.0.1", 0)),
        ["udpbcast"] = () =>
        {
            UdpListenLink peer = UdpListenLink.Open("0.0.0.0", 0);
            return new LinkPairBed(UdpBroadcastLink.Open("127.255.255.255", peer.Port), peer);
        },
        ["udpout, reopening"] = () =>
        {
            UdpListenLink peer = UdpListenLink.Open("127.0.0.1", 0);
            return new LinkPairBed(ReopeningLink.Open(LinkUrl.Parse($"udpout:127.0.0.1:{peer.Port}")), peer);
        },
    };

    public static IEnumerable<object[]> Kinds() => Beds.Keys.Select(k => new object[] { k });

    [Theory]
    [MemberData(nameof(Kinds))]
    public void TryWrite_RoomIsThere_ArrivesInOrderAmongWritesAndIsCounted(string kind)
    {
        using LinkTestBed bed = Beds[kind]();
        Assert.True(Direct(bed).TryWrite(new byte[] { 9, 1, 2, 9 }, 1, 2));
        bed.Link.Write(new byte[] { 3 }, 0, 1);
        Assert.True(Direct(bed).TryWrite(new byte[] { 4 }, 0, 1));

        Assert.Equal(new byte[] { 1, 2, 3, 4 }, bed.PeerReceives(4));
        Assert.Equal((4L, 0L), (bed.Link.Counters.BytesWritten, bed.Link.Counters.BytesDropped));
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void TryWrite_AfterUnblockAndDispose_IsFalseAndCountsNothing(string kind)
    {
        using LinkTestBed bed = Beds[kind]();
        bed.Link.Unblock();
        Assert.False(Direct(bed).TryWrite(new byte[1], 0, 1));
        bed.Link.Dispose();
        Assert.False(Direct(bed).TryWrite(new byte[1], 0, 1));
        Assert.Equal((0L, 0L), (bed.Link.Counters.BytesWritten, bed.Link.Counters.BytesDropped));
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void TryWrite_BadArguments_IsLeftToWriteWhichNamesThem(string kind)
    {
        using LinkTestBed bed = Beds[kind]();
        foreach ((int offset, int count) in new[] { (-1, 1), (0, -1), (3, 2), (5, 0), (0, 0), (1, int.MaxValue) })
            Assert.False(Direct(bed).TryWrite(new byte[4], offset, count));
        Assert.False(Direct(bed).TryWrite(null!, 0, 0));
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void TryWrite_SteadyState_AllocatesNothing(string kind)
    {
        // The calls that allocate nothing do not exist on Mono.
        if (Type.GetType("Mono.Runtime") is not null)
            return;
        using LinkTestBed bed = Beds[kind]();
        var frame = new byte[44];
        Write();

        Assert.Equal(0, Allocated.By(Write));

        void Write()
        {
            for (int i = 0; i < 20; i++)
                Assert.True(Direct(bed).TryWrite(frame, 0, frame.Length));
        }
    }

    [Fact]
    public void TryWrite_BeforeAPeerIsKnown_IsLeftToWriteWhichCountsIt()
    {
        using UdpListenLink link = UdpListenLink.Open("127.0.0.1", 0);

        Assert.False(link.TryWrite(new byte[7], 0, 7));

        LinkCounters counters = link.Counters;
        Assert.Equal((0L, 0L, 0L), (counters.BytesWritten, counters.BytesDropped, counters.TransientFaults));
    }

    // To many takes long, and may fill the socket: one that has no time for that leaves it to another thread.
    [Fact]
    public void TryWrite_MorePeersThanAFew_ReachesNone()
    {
        using UdpListenLink link = UdpListenLink.Open("127.0.0.1", 0);
        var peers = Enumerable.Range(0, 5).Select(_ => UdpSendLink.Open("127.0.0.1", link.Port)).ToList();
        foreach (UdpSendLink peer in peers.Take(4))
            Introduce(peer, link);
        Assert.True(link.TryWrite(new byte[3], 0, 3));
        Introduce(peers[4], link);

        Assert.False(link.TryWrite(new byte[5], 0, 5));
        link.Write(new byte[7], 0, 7);

        Assert.All(peers.Take(4), p => Assert.Equal(3, p.Read(new byte[10], 10_000).Count));
        Assert.All(peers, p => Assert.Equal(7, p.Read(new byte[10], 10_000).Count));
        Assert.Equal((10L, 0L), (link.Counters.BytesWritten, link.Counters.TransientFaults));
        peers.ForEach(p => p.Dispose());
    }

    // The network refuses a datagram with the next call.
    [Fact]
    public void TryWrite_PeerIsGone_CountsTheRefusalAndWriteGoesOn()
    {
        UdpListenLink peer = UdpListenLink.Open("127.0.0.1", 0);
        using UdpSendLink link = UdpSendLink.Open("127.0.0.1", peer.Port);
        peer.Dispose();

        int refused = 0;
        for (int i = 0; i < 20; i++)
        {
            if (!link.TryWrite(new byte[2], 0, 2))
            {
                refused++;
                link.Write(new byte[2], 0, 2);
            }
        }

        Assert.InRange(refused, 1, 20);
        Assert.InRange(link.Counters.TransientFaults, refused, 40);
        Assert.Equal(40, link.Counters.BytesWritten + link.Counters.BytesDropped);
    }

    [Fact]
    public void TryWrite_LinkThatOpensAgainWithNothingBehindIt_IsFalse()
    {
        var pair = new MemoryLinkPair("memory");
        using var none = new ReopeningLink("memory:none", () => pair.A, blocks: false);

        Assert.False(none.TryWrite(new byte[1], 0, 1));
        none.Read(new byte[1]);
        Assert.Equal(ByteLinkState.Open, none.State);
        Assert.False(none.TryWrite(new byte[1], 0, 1));
    }

    private static INonBlockingWriter Direct(LinkTestBed bed) => Assert.IsAssignableFrom<INonBlockingWriter>(bed.Link);

    private static LinkPairBed ToOnePeer(UdpListenLink link)
    {
        UdpSendLink peer = UdpSendLink.Open("127.0.0.1", link.Port);
        Introduce(peer, link);
        return new LinkPairBed(link, peer);
    }

    private static void Introduce(UdpSendLink peer, UdpListenLink link)
    {
        peer.Write(new byte[] { 1 }, 0, 1);
        Assert.Equal(1, link.Read(new byte[10], 10_000).Count);
    }
}
