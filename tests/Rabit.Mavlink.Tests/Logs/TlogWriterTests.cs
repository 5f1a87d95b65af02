using System;
using System.IO;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests.Framing;
using Xunit;

namespace Rabit.Mavlink.Tests.Logs;

public class TlogWriterTests
{
    private readonly MemoryStream _stream = new();
    private readonly TlogWriter _writer;

    public TlogWriterTests() => _writer = new TlogWriter(_stream);

    [Fact]
    public void Write_Frame_GivesBigEndianTimeAndTheFramesBytes()
    {
        MavlinkFrame frame = MavlinkFrame.Create(new Heartbeat { CustomMode = 1 }, 1, 1, 7);

        Assert.True(_writer.Write(0x0001020304050607, frame));

        Assert.Equal(Wire.Join([0, 1, 2, 3, 4, 5, 6, 7], Wire.Bytes(frame)), _stream.ToArray());
        Assert.Equal((1, 0), (_writer.Records, _writer.OmittedRecords));
    }

    [Fact]
    public void Write_SignedFrame_KeepsTheSignature()
    {
        byte[] signed = Wire.V2(0, [1], Wire.Info<Heartbeat>().CrcExtra, incompatibilityFlags: 1);
        _writer.Write(0, Wire.Single(signed, out _));

        Assert.Equal(Wire.Join(new byte[8], signed), _stream.ToArray());
    }

    [Fact]
    public void Write_SetupSigning_IsLeftOutAndCounted()
    {
        Assert.False(_writer.Write(0, MavlinkFrame.Create(default(SetupSigning), 1, 1, 0)));

        Assert.Equal((0, 0, 1), (_stream.Length, _writer.Records, _writer.OmittedRecords));
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(long.MaxValue)]
    public void Write_ImpossibleTime_Throws(long time) =>
        Assert.Throws<ArgumentOutOfRangeException>(
            "timeMicroseconds", () => _writer.Write(time, MavlinkFrame.Create(default(Heartbeat), 1, 1, 0)));

    [Fact]
    public void Write_EmptyFrame_Throws() => Assert.Throws<ArgumentException>("frame", () => _writer.Write(0, default));

    [Fact]
    public void Constructor_StreamThatCannotBeWritten_Throws()
    {
        Assert.Throws<ArgumentNullException>("stream", () => new TlogWriter(null!));
        Assert.Throws<ArgumentException>("stream", () => new TlogWriter(new OneWayStream([], 0)));
    }
}
