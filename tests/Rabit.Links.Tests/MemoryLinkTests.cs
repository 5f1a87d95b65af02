using System;
using System.Linq;
using Xunit;

namespace Rabit.Links.Tests;

public sealed class MemoryLinkTests : ConnectedLinkContract
{
    protected override string PeerGoneReason => "the other end was closed";

    protected override LinkTestBed Open()
    {
        var pair = new MemoryLinkPair("test");
        return new LinkPairBed(pair.A, pair.B);
    }

    [Fact]
    public void Read_NothingWritten_ReturnsAtOnce()
    {
        var pair = new MemoryLinkPair("test");

        Assert.False(pair.A.Blocks);
        Assert.Equal(LinkReadKind.NothingYet, pair.A.Read(new byte[1]).Kind);
    }

    [Fact]
    public void Url_OfEachEnd_NamesPairAndEnd()
    {
        var pair = new MemoryLinkPair("radio");

        Assert.Equal(("memory:radio/a", "memory:radio/b"), (pair.A.Url, pair.B.Url));
    }

    [Fact]
    public void Write_MoreThanFits_DropsItWholeAndCountsIt()
    {
        var pair = new MemoryLinkPair("test", capacityBytes: 10);
        pair.A.Write(new byte[8], 0, 8);

        pair.A.Write(new byte[3], 0, 3);
        pair.A.Write(new byte[2], 0, 2);

        Assert.Equal(
            (10, 3, 1), (pair.A.Counters.BytesWritten, pair.A.Counters.BytesDropped, pair.A.Counters.WritesDropped));
        Assert.Equal(10, pair.B.Read(new byte[100]).Count);
    }

    [Fact]
    public void ReadAndWrite_RoundAndRound_KeepTheBytes()
    {
        const int seed = 20261121;
        var random = new Random(seed);
        var pair = new MemoryLinkPair("test", capacityBytes: 13);
        byte written = 0;
        byte read = 0;
        for (int i = 0; i < 10_000; i++)
        {
            byte[] bytes = new byte[random.Next(1, 14)];
            for (int j = 0; j < bytes.Length; j++) bytes[j] = (byte)(written + j);
            long droppedBefore = pair.A.Counters.BytesDropped;
            pair.A.Write(bytes, 0, bytes.Length);
            if (pair.A.Counters.BytesDropped == droppedBefore) written += (byte)bytes.Length;

            byte[] target = new byte[random.Next(1, 14)];
            int count = pair.B.Read(target).Count;
            for (int j = 0; j < count; j++) Assert.True(target[j] == read++, $"seed {seed}, step {i}");
        }

        Assert.True(pair.A.Counters.BytesDropped > 0);
    }

    [Fact]
    public void ReadableCallback_EachWriteAndEachEnd_IsCalled()
    {
        var pair = new MemoryLinkPair("test");
        int calls = 0;
        pair.B.SetReadableCallback(() => calls++);

        pair.A.Write(new byte[1], 0, 1);
        pair.A.Write(new byte[1], 0, 1);
        Assert.Equal(2, calls);
        pair.A.Dispose();
        Assert.Equal(3, calls);
        pair.B.Unblock();
        Assert.Equal(4, calls);
    }

    [Fact]
    public void ReadableCallback_MayReadTheLink()
    {
        var pair = new MemoryLinkPair("test");
        byte[] target = new byte[10];
        LinkRead read = default;
        pair.B.SetReadableCallback(() => read = pair.B.Read(target));

        pair.A.Write(new byte[] { 1, 2, 3 }, 0, 3);

        Assert.Equal(new byte[] { 1, 2, 3 }, target.Take(read.Count));
    }

    [Fact]
    public void Read_PeerWent_HandsOutWhatItLeftFirst()
    {
        var pair = new MemoryLinkPair("test");
        pair.A.Write(new byte[3], 0, 3);
        pair.A.Dispose();

        Assert.Equal(3, pair.B.Read(new byte[10]).Count);
        Assert.Equal("ended: the other end was closed", pair.B.Read(new byte[10]).ToString());
    }

    [Theory]
    [InlineData("", 1)]
    [InlineData("x", 0)]
    public void New_BadArgument_Throws(string name, int capacityBytes) =>
        Assert.ThrowsAny<ArgumentException>(() => new MemoryLinkPair(name, capacityBytes));
}
