using System;

namespace Rabit.Links.Tests;

/// <summary>A link of ours at both ends.</summary>
internal sealed class LinkPairBed : LinkTestBed
{
    private readonly IByteLink _peer;
    private readonly LinkCollector _peerReads;

    public LinkPairBed(IByteLink link, IByteLink peer)
    {
        Link = link;
        _peer = peer;
        _peerReads = new LinkCollector(peer);
    }

    public override IByteLink Link { get; }

    public override void PeerSends(params byte[] bytes) => _peer.Write(bytes, 0, bytes.Length);

    public override byte[] PeerReceives(int count) => _peerReads.Take(count);

    public override void PeerGoes() => _peer.Dispose();
}
