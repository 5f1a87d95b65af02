using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Framing;

public class MavlinkFrameReaderTests
{
    private static readonly byte[] Known = Wire.Of(new Heartbeat { CustomMode = 77, MavlinkVersion = 3 }, sequence: 5);
    private static readonly byte[] Unknown = Wire.V2(Wire.UnknownId, [1, 2, 3, 4, 5, 6, 7, 8]);
    private static readonly byte[] TruncatedHeader = [0xFD, 0xFF, 0, 0, 1];

    private readonly MavlinkFrameReader _reader = new(MavlinkDialect.All);

    [Fact]
    public void Constructor_NoDialect_Throws()
        => Assert.Throws<ArgumentNullException>("dialect", () => new MavlinkFrameReader(null!));

    [Fact]
    public void TryRead_LastByteMissing_WaitsForIt()
    {
        Assert.Empty(Feed(Known.Take(Known.Length - 1).ToArray()));
        Assert.Equal(Known.Length - 1, _reader.PendingBytes);
        Assert.Single(Feed(Known[Known.Length - 1]));
        Assert.Equal(0, _reader.PendingBytes);
    }

    [Fact]
    public void TryRead_NoiseBeforeFrame_ReportsWhereTheFrameBegan()
    {
        FoundFrame frame = Assert.Single(Feed(Wire.Join([1, 2, 3], Known)));

        Assert.Equal(3, frame.Info.StreamOffset);
        Assert.Equal("HEARTBEAT", frame.Info.Message.Name);
        Assert.Equal((3, 1, 24), (_reader.Counters.SkippedBytes, _reader.Counters.Frames, _reader.Counters.Bytes));
    }

    [Fact]
    public void TryRead_TruncatedHeaderBeforeFrame_DeliversTheFrame()
    {
        // The header claims 255 bytes, and with the bytes behind it an unknown id: what is proved inside wins, at once.
        FoundFrame frame = Assert.Single(Feed(Wire.Join(TruncatedHeader, Known)));

        Assert.Equal(TruncatedHeader.Length, frame.Info.StreamOffset);
        Assert.Equal(TruncatedHeader.Length, _reader.Counters.SkippedBytes);
    }

    [Fact]
    public void TryRead_BadChecksum_IsCountedAndTheFrameInsideIsFound()
    {
        // A TUNNEL that carries a whole frame in its payload: skipped over when whole, searched when damaged.
        MavlinkMessageInfo tunnel = Wire.Info<Tunnel>();
        byte[] outer = Wire.V2(tunnel.Id, Wire.Join(new byte[5], Known), tunnel.CrcExtra);

        Assert.Equal("TUNNEL", Assert.Single(Feed(outer)).Info.Message.Name);
        outer[4] ^= 1;
        Assert.Equal("HEARTBEAT", Assert.Single(Feed(outer)).Info.Message.Name);
        Assert.Equal(1, _reader.Counters.BadChecksums);
    }

    [Fact]
    public void TryRead_UnknownIdRightAfterAFrame_IsDeliveredAtOnceUnchecked()
    {
        List<FoundFrame> found = Feed(Wire.Join(Known, Unknown));

        Assert.Equal([true, false], found.Select(frame => frame.Info.IsChecked));
        Assert.Equal(Unknown, Wire.Bytes(found[1].Frame));
        Assert.Null(found[1].Info.Message.Name);
        Assert.Equal((1, 1), (_reader.Counters.Frames, _reader.Counters.UnknownFrames));
    }

    [Fact]
    public void TryRead_UnknownIdAfterNoise_IsDeliveredWhenAnotherFrameFollows()
    {
        Assert.Empty(Feed(Wire.Join([0], Unknown)));
        Assert.Single(Feed(Unknown[0]));
    }

    [Fact]
    public void TryRead_UnknownIdBetweenNoise_IsSkipped()
    {
        Assert.Empty(Feed(Wire.Join([0], Unknown, [0])));
        Assert.Equal(Unknown.Length + 2, _reader.Counters.SkippedBytes);
    }

    [Fact]
    public void TryRead_UnknownIdWithStartOfKnownFrameInside_WaitsUntilItIsValidated()
    {
        byte[] unknown = Wire.V2(Wire.UnknownId, Wire.Join(new byte[10], Known.Take(12).ToArray()));

        Assert.Empty(Feed(unknown));
        Assert.Single(Feed(new byte[Known.Length]));
        Assert.Equal(1, _reader.Counters.UnknownFrames);
    }

    [Fact]
    public void TryRead_UnknownIdSigned_KeepsTheSignature()
    {
        byte[] signed = Wire.V2(Wire.UnknownId, [1, 2, 3], incompatibilityFlags: 1);

        Assert.Equal(signed, Wire.Bytes(Assert.Single(Feed(signed)).Frame));
    }

    [Theory]
    [InlineData(0, 0x02)]
    [InlineData(0, 0x81)]
    [InlineData(Wire.UnknownId, 0x40)]
    public void TryRead_UnknownIncompatibilityFlag_DropsTheFrameWholeAndCounts(int messageId, byte flags)
    {
        byte[] frame = Wire.V2(messageId, [1], Wire.Info<Heartbeat>().CrcExtra, flags);

        Assert.Single(Feed(Wire.Join(frame, Known)));
        Assert.Equal(
            (1, 0, 0),
            (_reader.Counters.IncompatibleFrames, _reader.Counters.SkippedBytes, _reader.Counters.BadChecksums));
    }

    [Fact]
    public void TryFlush_UnfinishedFrameHoldsBackOthers_DeliversThem()
    {
        // A header of a known id with 255 bytes of payload, then silence.
        byte[] header = [0xFD, 0xFF, 0, 0, 0, 1, 1, 0, 0, 0];
        Assert.Empty(Feed(Wire.Join(header, Known)));

        Assert.True(_reader.TryFlush(out MavlinkFrame frame, out MavlinkFrameInfo info));
        Assert.Equal(Known, Wire.Bytes(frame));
        Assert.Equal(header.Length, info.StreamOffset);
        Assert.False(_reader.TryFlush(out _, out _));
        Assert.Equal(0, _reader.PendingBytes);
        Assert.Equal(header.Length, _reader.Counters.SkippedBytes);
    }

    [Fact]
    public void TryRead_AfterFlush_GoesOnWithTheStreamOffset()
    {
        Feed([0xFD, 0xFF]);
        Assert.False(_reader.TryFlush(out _, out _));

        Assert.Equal(2, Assert.Single(Feed(Unknown)).Info.StreamOffset);
    }

    [Fact]
    public void TryRead_V1WithImpossibleLength_IsNoFrame()
    {
        byte[] frame = Wire.Of(default(Heartbeat), version: MavlinkVersion.V1);
        frame[1] = 10;

        Assert.Empty(Feed(Wire.Join(frame, new byte[300])));
        Assert.Equal(0, _reader.Counters.BadChecksums);
    }

    private List<FoundFrame> Feed(params byte[] bytes)
        => FrameCollector.Read(bytes, bytes.Length, _reader, flush: false);
}
