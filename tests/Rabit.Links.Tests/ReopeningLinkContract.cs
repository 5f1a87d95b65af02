using System;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using Xunit;

namespace Rabit.Links.Tests;

/// <summary>What a link promises besides that opens another one again and again.</summary>
public abstract class ReopeningLinkContract : ByteLinkContract
{
    /// <summary>So that a test of many cycles takes seconds.</summary>
    protected static readonly LinkOptions Quick = new(
        writeTimeout: TimeSpan.FromMilliseconds(200), firstReopenDelay: TimeSpan.FromMilliseconds(1),
        maxReopenDelay: TimeSpan.FromMilliseconds(20));

    /// <summary>What the link says of a peer that went away.</summary>
    protected abstract string PeerGoneReason { get; }

    protected override LinkTestBed Open()
    {
        ReopeningBed bed = OpenBed(Quick);
        bed.ComeUp();
        Await(() =>
        {
            Assert.Equal(LinkReadKind.NothingYet, bed.Link.Read(new byte[1], 1).Kind);
            return bed.Link.State == ByteLinkState.Open;
        });
        bed.AwaitPeer();
        return bed;
    }

    /// <summary>A link whose other end is not there yet.</summary>
    protected abstract ReopeningBed OpenBed(LinkOptions options);

    [Fact]
    public void Read_PeerNotThereAtTheStart_WaitsForIt()
    {
        using ReopeningBed bed = OpenBed(Quick);
        var collector = new LinkCollector(bed.Link);
        Assert.False(collector.EndsWithin(TimeSpan.FromMilliseconds(50)));
        Assert.NotEqual(ByteLinkState.Open, bed.Link.State);
        Assert.NotNull(bed.Link.LastFault);

        bed.ComeUp();
        bed.AwaitPeer();
        bed.PeerSends(1, 2);

        Assert.Equal(new byte[] { 1, 2 }, collector.Take(2));
        Assert.Equal((ByteLinkState.Open, 1L), (bed.Link.State, bed.Link.Counters.Openings));
    }

    [Fact]
    public void Read_PeerGoesAndComesBack_GoesOn()
    {
        using ReopeningBed bed = OpenBed(Quick);
        var collector = new LinkCollector(bed.Link);
        for (byte cycle = 0; cycle < 5; cycle++)
        {
            bed.ComeUp();
            bed.AwaitPeer();
            bed.PeerSends(cycle, 7);
            Assert.Equal(new byte[] { cycle, 7 }, collector.Take(2));
            byte[] answer = { 8, cycle };
            bed.Link.Write(answer, 0, 2);
            Assert.Equal(answer, bed.PeerReceives(2));

            bed.PeerGoes();
            Await(() => bed.Link.State != ByteLinkState.Open);
        }

        LinkCounters counters = bed.Link.Counters;
        Assert.Equal((10L, 10L, 0L, 5L),
            (counters.BytesRead, counters.BytesWritten, counters.BytesDropped, counters.Openings));
    }

    [Fact]
    public void LastFault_AfterThePeerWent_SaysWhy()
    {
        using ReopeningBed bed = OpenBed(new LinkOptions(
            firstReopenDelay: TimeSpan.FromSeconds(2), maxReopenDelay: TimeSpan.FromSeconds(2)));
        bed.ComeUp();
        var collector = new LinkCollector(bed.Link);
        bed.AwaitPeer();

        bed.PeerGoes();
        Await(() => bed.Link.State == ByteLinkState.WaitingToReopen);

        Assert.Equal(PeerGoneReason, bed.Link.LastFault);
        Assert.False(collector.EndsWithin(TimeSpan.Zero));
    }

    [Fact]
    public void Write_WhileNotOpen_IsDroppedAndCountedAtOnce()
    {
        using ReopeningBed bed = OpenBed(Quick);
        var watch = Stopwatch.StartNew();

        for (int i = 0; i < 100; i++) bed.Link.Write(new byte[7], 0, 7);

        Assert.Equal((0L, 700L, 100L), (bed.Link.Counters.BytesWritten, bed.Link.Counters.BytesDropped,
            bed.Link.Counters.WritesDropped));
        Assert.InRange(watch.Elapsed, TimeSpan.Zero, TimeSpan.FromSeconds(2));
    }

    [Fact]
    public void Unblock_WhileWaitingToReopen_EndsTheReadWithin100Milliseconds()
    {
        TimeSpan best = TimeSpan.MaxValue; // of five, so that a busy machine does not matter
        for (int attempt = 0; attempt < 5; attempt++)
        {
            using ReopeningBed bed = OpenBed(new LinkOptions(
                firstReopenDelay: TimeSpan.FromSeconds(2), maxReopenDelay: TimeSpan.FromSeconds(2)));
            var collector = new LinkCollector(bed.Link);
            Assert.False(collector.EndsWithin(TimeSpan.FromMilliseconds(20)));

            var watch = Stopwatch.StartNew();
            bed.Link.Unblock();
            LinkRead end = collector.WaitForEnd();

            if (watch.Elapsed < best) best = watch.Elapsed;
            Assert.Equal("it was closed on this side", end.Reason);
            Assert.Equal(ByteLinkState.Closed, bed.Link.State);
        }

        Assert.True(best < TimeSpan.FromMilliseconds(100), $"the best of five took {best.TotalMilliseconds} ms");
    }

    [Fact]
    public void Reopen_ThousandTimes_LeaksNoThreadAndNoHandle()
    {
        using ReopeningBed bed = OpenBed(Quick);
        var collector = new LinkCollector(bed.Link);
        (int Threads, int Handles) before = default;
        var watch = Stopwatch.StartNew();
        for (int cycle = 0; cycle < 1000; cycle++)
        {
            bed.ComeUp();
            bed.AwaitPeer();
            bed.PeerSends(1);
            collector.Take(1);
            bed.PeerGoes();
            Await(() => bed.Link.State != ByteLinkState.Open);
            if (cycle == 20) before = Usage();
        }

        (int Threads, int Handles) after = Usage();
        Assert.InRange(watch.Elapsed, TimeSpan.Zero, TimeSpan.FromMinutes(2));
        Assert.InRange(bed.Link.Counters.Openings, 1000, 2000);

        // The other tests of the run, and the pool, have threads and handles too.
        Assert.InRange(after.Threads - before.Threads, -1000, 40);
        Assert.InRange(after.Handles - before.Handles, -1000, 100);
    }

    protected static void Await(Func<bool> condition)
    {
        var watch = Stopwatch.StartNew();
        while (!condition())
        {
            if (watch.Elapsed > LinkTestBed.TestTimeout) throw new TimeoutException("it did not come about");
            Thread.Sleep(1);
        }
    }

    private static (int Threads, int Handles) Usage()
    {
        GC.Collect();
        GC.WaitForPendingFinalizers();
        return (System.IO.Directory.GetFileSystemEntries("/proc/self/task").Length,
            System.IO.Directory.EnumerateFileSystemEntries("/proc/self/fd").Count());
    }
}
