using System;
using System.Threading;
using Xunit;

namespace Rabit.Links.Tests;

/// <summary>What the links promise besides whose writes wait for room on the way out.</summary>
public abstract class FillingLinkContract : ConnectedLinkContract
{
    private static readonly byte[] MoreThanFits = new byte[32 * 1024 * 1024];

    protected override LinkTestBed Open() => Open(LinkOptions.Default);

    protected abstract LinkTestBed Open(LinkOptions options);

    [Fact]
    public void Write_PeerDoesNotRead_ThrowsAfterTheTimeoutAndCountsTheRest()
    {
        using LinkTestBed bed = Open(new LinkOptions(writeTimeout: TimeSpan.FromMilliseconds(50)));
        LinkCounters before = bed.Link.Counters;

        var fault = Assert.Throws<LinkException>(() => bed.Link.Write(MoreThanFits, 0, MoreThanFits.Length));

        LinkCounters after = bed.Link.Counters;
        Assert.False(fault.LinkEnded);
        Assert.Contains("took no more for 50 ms", fault.Message, StringComparison.Ordinal);
        Assert.Equal(1, after.WritesDropped);
        Assert.Equal(MoreThanFits.Length, after.BytesWritten - before.BytesWritten + after.BytesDropped);
    }

    [Fact]
    public void Unblock_WhileAWriteWaits_EndsIt()
    {
        using LinkTestBed bed = Open(new LinkOptions(writeTimeout: TimeSpan.FromMinutes(10)));
        LinkException? fault = null;
        var writer = new Thread(
            () => fault =
                Record.Exception(() => bed.Link.Write(MoreThanFits, 0, MoreThanFits.Length)) as LinkException);
        writer.IsBackground = true;
        writer.Start();
        Assert.False(writer.Join(50));

        bed.Link.Unblock();

        Assert.True(writer.Join(LinkTestBed.TestTimeout));
        Assert.True(fault?.LinkEnded);
        Assert.Equal(MoreThanFits.Length, bed.Link.Counters.BytesWritten + bed.Link.Counters.BytesDropped);
    }
}
