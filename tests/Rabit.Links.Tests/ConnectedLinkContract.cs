using System;
using Xunit;

namespace Rabit.Links.Tests;

/// <summary>What the links promise besides that see when the other end goes away.</summary>
public abstract class ConnectedLinkContract : ByteLinkContract
{
    protected abstract string PeerGoneReason { get; }

    [Fact]
    public void Read_AfterThePeerWent_SaysThatTheLinkEndedAndWhy()
    {
        using LinkTestBed bed = Open();
        var collector = new LinkCollector(bed.Link);
        bed.PeerSends(1, 2, 3);
        Assert.Equal(new byte[] { 1, 2, 3 }, collector.Take(3));

        bed.PeerGoes();

        Assert.Equal(PeerGoneReason, collector.WaitForEnd().Reason);
        Assert.Equal(PeerGoneReason, bed.Link.Read(new byte[1]).Reason);
        Assert.Equal((ByteLinkState.Closed, PeerGoneReason), (bed.Link.State, bed.Link.LastFault));
    }

    [Fact]
    public void Write_AfterThePeerWent_Throws()
    {
        using LinkTestBed bed = Open();
        var collector = new LinkCollector(bed.Link);
        bed.PeerGoes();
        collector.WaitForEnd();

        var fault = Assert.Throws<LinkException>(() => bed.Link.Write(new byte[2], 0, 2));

        Assert.True(fault.LinkEnded);
        Assert.Equal($"link {bed.Link.Url}: cannot write: {PeerGoneReason}", fault.Message);
        Assert.Equal(2, bed.Link.Counters.BytesDropped);
    }
}
