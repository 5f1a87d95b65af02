using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Framing;

/// <summary>The mode that skips a rejected frame whole: what lies inside is never taken for a frame.</summary>
public class ResyncTests
{
    private static readonly byte[] Inner = Wire.Of(new Heartbeat { CustomMode = 5 });
    private static readonly byte[] Behind = Wire.Of(new Attitude { Yaw = 1 });

    private readonly MavlinkFrameReader _reader = new(MavlinkDialect.All, MavlinkInvalidFramePolicy.SkipFrame);

    [Fact]
    public void SkipFrame_DamagedFrameThatCarriesOne_DeliversOnlyWhatFollows()
    {
        byte[] outer = Tunnel();
        outer[4] ^= 1;

        Assert.Equal([Attitude.MavlinkId], Ids(Wire.Join(outer, Behind)));
        Assert.Equal((1, outer.Length), (_reader.Counters.BadChecksums, _reader.Counters.SkippedBytes));
    }

    [Fact]
    public void SkipFrame_UnknownIdThatCarriesAFrame_IsDeliveredWhole()
    {
        byte[] unknown = Wire.V2(Wire.UnknownId, Inner);

        Assert.Equal([Heartbeat.MavlinkId, Wire.UnknownId, Attitude.MavlinkId], Ids(Wire.Join(Inner, unknown, Behind)));
        // The other policy delivers what the checksum proves.
        Assert.DoesNotContain(
            Wire.UnknownId, Ids(Wire.Join(Inner, unknown, Behind), new MavlinkFrameReader(MavlinkDialect.All)));
    }

    [Fact]
    public void SkipFrame_StreamEndsInsideAFrameThatCarriesOne_DeliversNothingOfIt()
    {
        byte[] outer = Tunnel();

        Assert.Empty(Ids(outer.Take(outer.Length - 1).ToArray()));
        Assert.Equal((outer.Length - 1, 0), (_reader.Counters.SkippedBytes, _reader.PendingBytes));
    }

    [Fact]
    public void SkipFrame_FalseHeader_CostsWhatItClaims()
    {
        byte[] header = [0xFD, 30, 0, 0, 0, 1, 1, 0, 0, 0];
        byte[] first = Wire.Of(new Heartbeat { CustomMode = 1, MavlinkVersion = 3 });

        // 30 bytes of payload and two of checksum: the first frame is inside, the second is behind.
        byte[] stream = Wire.Join(header, first, new byte[32 - first.Length], Behind);
        Assert.Equal([Attitude.MavlinkId], Ids(stream));
        Assert.Equal(
            [Heartbeat.MavlinkId, Attitude.MavlinkId], Ids(stream, new MavlinkFrameReader(MavlinkDialect.All)));
    }

    [Fact]
    public void SkipFrame_IntactFlight_IsReadAsInTheOtherMode()
    {
        byte[] stream = Stream("px4-flight.tlog");
        string[] expected = FrameCollector.Read(stream, 1000, new MavlinkFrameReader(MavlinkDialect.All))
            .Select(frame => frame.ToString()).ToArray();

        Assert.Equal(
            expected, FrameCollector.Read(stream, 1000, _reader).Select(frame => frame.ToString()),
            StringComparer.Ordinal);
        Assert.Equal(0, _reader.Counters.SkippedBytes);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(7)]
    [InlineData(280)]
    [InlineData(100_000)]
    public void SkipFrame_AnyChunks_FindsTheSame(int chunk)
    {
        byte[] stream = TestData.Bytes("c-garbage-part.bin");
        var whole = new MavlinkFrameReader(MavlinkDialect.All, MavlinkInvalidFramePolicy.SkipFrame);
        string[] expected = FrameCollector.Read(stream, stream.Length, whole)
            .Select(frame => frame.ToString()).ToArray();

        Assert.Equal(
            expected, FrameCollector.Read(stream, chunk, _reader).Select(frame => frame.ToString()),
            StringComparer.Ordinal);
        Assert.Equal(
            (whole.Counters.SkippedBytes, whole.Counters.BadChecksums),
            (_reader.Counters.SkippedBytes, _reader.Counters.BadChecksums));
        Assert.Equal(stream.Length, _reader.Counters.Bytes);
    }

    private static byte[] Tunnel() => Wire.V2(
        Mavlink.Messages.Tunnel.MavlinkId, Wire.Join(new byte[5], Inner), Mavlink.Messages.Tunnel.MavlinkCrcExtra);

    private static byte[] Stream(string log)
    {
        var frames = new List<byte[]>();
        var reader = new TlogReader(new System.IO.MemoryStream(TestData.Bytes(log)), MavlinkDialect.All);
        while (reader.TryRead(out MavlinkFrame frame, out _))
            frames.Add(Wire.Bytes(frame));
        return Wire.Join([.. frames]);
    }

    private List<int> Ids(byte[] bytes, MavlinkFrameReader? reader = null) =>
        FrameCollector.Read(bytes, bytes.Length, reader ?? _reader).ConvertAll(frame => frame.Frame.MessageId);
}
