using System;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using Xunit;

namespace Rabit.Links.Tests;

/// <summary>What every link promises, see <see cref="IByteLink"/>.</summary>
public abstract class ByteLinkContract
{
    // Small enough for what the smallest way (a pty) holds when the peer does not read: 40 writes of at most 60 bytes.
    private const int WritesPerBatch = 40;
    private const int Batches = 25;

    // Not in the reference assemblies of net472.
    private static readonly Func<long> AllocatedBytes =
        (Func<long>)Delegate.CreateDelegate(
            typeof(Func<long>), typeof(GC).GetMethod("GetAllocatedBytesForCurrentThread")!);

    /// <summary>Opens a link and its peer, bytes from each having reached the other where that matters.</summary>
    protected abstract LinkTestBed Open();

    /// <summary>Bytes that one read and one write may allocate together.</summary>
    protected virtual long AllocationLimit => 0;

    [Fact]
    public void Read_ManyWritesOfThePeer_ArriveInOrder()
    {
        using LinkTestBed bed = Open();
        var collector = new LinkCollector(bed.Link);
        for (int batch = 0; batch < Batches; batch++)
        {
            byte[][] writes = Chunks(batch);
            foreach (byte[] chunk in writes) bed.PeerSends(chunk);

            Assert.Equal(writes.SelectMany(c => c), collector.Take(writes.Sum(c => c.Length)));
        }
    }

    [Fact]
    public void Write_ManyTimes_ArrivesAtThePeerInOrder()
    {
        using LinkTestBed bed = Open();
        for (int batch = 0; batch < Batches; batch++)
        {
            byte[][] writes = Chunks(batch);
            foreach (byte[] chunk in writes) bed.Link.Write(chunk, 0, chunk.Length);

            Assert.Equal(writes.SelectMany(c => c), bed.PeerReceives(writes.Sum(c => c.Length)));
        }
    }

    [Fact]
    public void Write_PartOfABuffer_SendsThatPart()
    {
        using LinkTestBed bed = Open();

        bed.Link.Write(new byte[] { 1, 2, 3, 4, 5 }, 1, 3);
        bed.Link.Write(new byte[] { 6 }, 0, 0);
        bed.Link.Write(new byte[] { 7 }, 0, 1);

        Assert.Equal(new byte[] { 2, 3, 4, 7 }, bed.PeerReceives(4));
    }

    [Fact]
    public void Read_SmallerBufferThanWhatArrived_LosesNothing()
    {
        using LinkTestBed bed = Open();
        var collector = new LinkCollector(bed.Link, bufferBytes: 7);
        byte[] bytes = Enumerable.Range(0, 256).Select(i => (byte)i).ToArray();

        bed.PeerSends(bytes);

        Assert.Equal(bytes, collector.Take(bytes.Length));
    }

    [Fact]
    public void Write_WhileReadWaits_BothGoThrough()
    {
        using LinkTestBed bed = Open();
        var collector = new LinkCollector(bed.Link);
        Assert.False(collector.EndsWithin(TimeSpan.FromMilliseconds(20)));

        bed.Link.Write(new byte[] { 1, 2 }, 0, 2);
        Assert.Equal(new byte[] { 1, 2 }, bed.PeerReceives(2));

        bed.PeerSends(3);
        Assert.Equal(new byte[] { 3 }, collector.Take(1));
    }

    [Fact]
    public void Unblock_WhileReadWaits_EndsItWithin100Milliseconds()
    {
        TimeSpan best = TimeSpan.MaxValue; // of five, so that a busy machine does not matter
        for (int attempt = 0; attempt < 5; attempt++)
        {
            using LinkTestBed bed = Open();
            var collector = new LinkCollector(bed.Link);
            Assert.False(collector.EndsWithin(TimeSpan.FromMilliseconds(20)));

            var watch = Stopwatch.StartNew();
            bed.Link.Unblock();
            LinkRead end = collector.WaitForEnd();

            if (watch.Elapsed < best) best = watch.Elapsed;
            Assert.Equal("it was closed on this side", end.Reason);
        }

        Assert.True(best < TimeSpan.FromMilliseconds(100), $"the best of five took {best.TotalMilliseconds} ms");
    }

    [Fact]
    public void Unblock_WhileAReadBegins_NeverLeavesItWaiting()
    {
        for (int attempt = 0; attempt < 50; attempt++)
        {
            using LinkTestBed bed = Open();
            var collector = new LinkCollector(bed.Link);
            Thread.SpinWait(attempt * 500);

            bed.Link.Unblock();

            Assert.Equal(LinkReadKind.Ended, collector.WaitForEnd().Kind);
        }
    }

    [Fact]
    public void Unblock_BeforeReading_StaysEnded()
    {
        using LinkTestBed bed = Open();
        bed.PeerSends(1);

        bed.Link.Unblock();
        bed.Link.Unblock();

        for (int i = 0; i < 3; i++)
            Assert.Equal("ended: it was closed on this side", bed.Link.Read(new byte[8]).ToString());
    }

    [Fact]
    public void Write_AfterUnblock_ThrowsAndCountsTheBytes()
    {
        using LinkTestBed bed = Open();
        bed.Link.Unblock();
        LinkCounters before = bed.Link.Counters;

        var fault = Assert.Throws<LinkException>(() => bed.Link.Write(new byte[5], 1, 3));

        Assert.Equal($"link {bed.Link.Url}: cannot write: it was closed on this side", fault.Message);
        Assert.Equal((bed.Link.Url, true), (fault.Url, fault.LinkEnded));
        Assert.Equal((3, 1), (bed.Link.Counters.BytesDropped - before.BytesDropped,
            bed.Link.Counters.WritesDropped - before.WritesDropped));
    }

    [Fact]
    public void Read_TimeoutPasses_SaysSoAndLosesNothing()
    {
        using LinkTestBed bed = Open();
        byte[] buffer = new byte[10];
        var watch = Stopwatch.StartNew();

        for (int i = 0; i < 3; i++) Assert.Equal(LinkReadKind.NothingYet, bed.Link.Read(buffer, 30).Kind);
        TimeSpan waited = watch.Elapsed;
        bed.PeerSends(1, 2);
        LinkRead read = bed.Link.Read(buffer, 10_000);
        while (read.Kind == LinkReadKind.NothingYet) read = bed.Link.Read(buffer, 10_000);

        Assert.Equal(2, read.Count);
        if (bed.Link.Blocks) Assert.InRange(waited, TimeSpan.FromMilliseconds(80), LinkTestBed.TestTimeout);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-2)]
    public void Read_BadTimeout_NamesTheLink(int milliseconds)
    {
        using LinkTestBed bed = Open();

        Assert.Contains(
            bed.Link.Url,
            Assert.Throws<ArgumentOutOfRangeException>(() => bed.Link.Read(new byte[1], milliseconds)).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void State_OpenThenUnblocked_SaysSoWithoutAFault()
    {
        using LinkTestBed bed = Open();
        Assert.Equal((ByteLinkState.Open, 1L), (bed.Link.State, bed.Link.Counters.Openings));

        string? fault = bed.Link.LastFault; // of a link that was not there at first

        bed.Link.Unblock();

        Assert.Equal((ByteLinkState.Closed, fault), (bed.Link.State, bed.Link.LastFault));
    }

    [Fact]
    public void Dispose_WhileReadWaits_EndsIt()
    {
        using LinkTestBed bed = Open();
        var collector = new LinkCollector(bed.Link);
        Assert.False(collector.EndsWithin(TimeSpan.FromMilliseconds(20)));

        bed.Link.Dispose();

        Assert.True(collector.EndsWithin(LinkTestBed.TestTimeout));
        // else the next read found it disposed
        if (bed.Link.Blocks) Assert.Equal(LinkReadKind.Ended, collector.WaitForEnd().Kind);
    }

    [Fact]
    public void ReadAndWrite_AfterDispose_SayWhatWasDisposed()
    {
        using LinkTestBed bed = Open();
        IByteLink link = bed.Link;
        link.Dispose();

        Assert.Contains(
            link.Url, Assert.Throws<ObjectDisposedException>(() => link.Read(new byte[1])).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            link.Url, Assert.Throws<ObjectDisposedException>(() => link.Write(new byte[1], 0, 1)).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void OtherMembers_AfterDispose_StillWork()
    {
        using LinkTestBed bed = Open();
        bed.Link.Write(new byte[4], 0, 4);
        long written = bed.Link.Counters.BytesWritten;

        bed.Link.Dispose();
        bed.Link.Dispose();
        bed.Link.Unblock();
        bed.Link.SetReadableCallback(null);

        Assert.Equal(written, bed.Link.Counters.BytesWritten);
        Assert.NotEmpty(bed.Link.Url);
    }

    [Fact]
    public void Counters_AfterAnExchange_AreExact()
    {
        using LinkTestBed bed = Open();
        var collector = new LinkCollector(bed.Link);
        LinkCounters before = bed.Link.Counters;

        bed.PeerSends(new byte[100]);
        collector.Take(100);
        bed.Link.Write(new byte[30], 0, 30);
        bed.Link.Write(new byte[3], 0, 3);

        LinkCounters after = bed.Link.Counters;
        Assert.Equal((100, 33), (after.BytesRead - before.BytesRead, after.BytesWritten - before.BytesWritten));
        Assert.Equal((0, 0, 0), (after.BytesDropped, after.WritesDropped, after.TransientFaults));
    }

    [Fact]
    public void ReadAndWrite_SteadyState_AllocateNoMoreThanPromised()
    {
        using LinkTestBed bed = Open();
        byte[] buffer = new byte[100];
        const int exchanges = 200;
        const int warmUp = 100;
        long allocated = 0;
        for (int i = 0; i < warmUp + exchanges; i++)
        {
            bed.PeerSends(1, 2, 3);
            int collections = GC.CollectionCount(0);
            long before = AllocatedBytes();
            bed.Link.Write(buffer, 0, 20);
            int count = ReadSome(bed.Link, buffer);
            long bytes = AllocatedBytes() - before;

            // A collection in between, which any test beside this one may cause, counters what is left of this thread's
            // buffer.
            if (i >= warmUp && GC.CollectionCount(0) == collections) allocated += bytes;
            Assert.Equal(3, count);
            bed.PeerReceives(20);
        }

        Assert.InRange(allocated, 0, exchanges * AllocationLimit);
    }

    [Fact]
    public void ReadAndWrite_BadBuffer_NameTheLinkAndTheFault()
    {
        using LinkTestBed bed = Open();
        IByteLink link = bed.Link;

        Assert.Contains(
            link.Url, Assert.Throws<ArgumentException>(() => link.Read(Array.Empty<byte>())).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            link.Url, Assert.Throws<ArgumentNullException>(() => link.Read(null!)).Message, StringComparison.Ordinal);
        Assert.Contains(
            link.Url, Assert.Throws<ArgumentNullException>(() => link.Write(null!, 0, 0)).Message,
            StringComparison.Ordinal);
        foreach ((int offset, int count) in new[] { (-1, 1), (0, -1), (3, 2), (5, 0), (1, int.MaxValue) })
        {
            string message =
                Assert.Throws<ArgumentOutOfRangeException>(() => link.Write(new byte[4], offset, count)).Message;
            Assert.Contains(
                $"offset {offset} and count {count} do not lie in a buffer of 4 bytes", message,
                StringComparison.Ordinal);
        }
    }

    private static int ReadSome(IByteLink link, byte[] buffer)
    {
        LinkRead read = link.Read(buffer);
        while (read.Kind == LinkReadKind.NothingYet) read = link.Read(buffer);
        return read.Count;
    }

    /// <summary>Bytes of every value, in chunks of 1 to 60.</summary>
    private static byte[][] Chunks(int batch) => Enumerable.Range(0, WritesPerBatch)
        .Select(
            chunk => Enumerable.Range(0, 1 + ((chunk * 7) % 60))
                .Select(i => (byte)((batch * 31) + (chunk * 60) + i)).ToArray())
        .ToArray();
}
