using System;
using System.Linq;
using System.Runtime.InteropServices;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests.Golden;
using Xunit;

namespace Rabit.Mavlink.Tests.Framing;

public class MavlinkFrameTests
{
    private static readonly Heartbeat Sample = new() { CustomMode = 0x01020304, MavlinkVersion = 3 };

    [Fact]
    public void Create_V2_SetsTheHeader()
    {
        MavlinkFrame frame = MavlinkFrame.Create(Sample, 7, 191, 200);

        Assert.Equal(
            (MavlinkVersion.V2, 7, 191, 200, 0),
            (frame.Version, frame.SystemId, frame.ComponentId, frame.Sequence, frame.MessageId));
        Assert.Equal((0, 0, false, 9, 21), (frame.IncompatibilityFlags, frame.CompatibilityFlags, frame.IsSigned,
            frame.PayloadLength, frame.WireLength));
    }

    [Fact]
    public void Create_V2WithTrailingZeros_CutsThemButKeepsOneByte()
    {
        Assert.Equal(1, MavlinkFrame.Create(default(Heartbeat), 1, 1, 0).PayloadLength);
        Assert.Equal(1, MavlinkFrame.Create(new Heartbeat { CustomMode = 1 }, 1, 1, 0).PayloadLength);
        Assert.Equal(4, MavlinkFrame.Create(new Heartbeat { CustomMode = 1u << 24 }, 1, 1, 0).PayloadLength);
    }

    [Fact]
    public void Create_V1_SendsTheFieldsWithoutExtensions()
    {
        var ack = new CommandAck { ResultParam2 = 5, TargetSystem = 6 };

        MavlinkFrame frame = MavlinkFrame.Create(ack, 1, 1, 0, MavlinkVersion.V1);

        Assert.Equal(Wire.Info<CommandAck>().MinLength, frame.PayloadLength);
        Assert.True(frame.TryDecode(out CommandAck decoded));
        Assert.Equal((0, 0), (decoded.ResultParam2, decoded.TargetSystem));
    }

    [Fact]
    public void Create_V1WithIdAbove255_NamesMessageAndId()
    {
        var fault = Assert.Throws<ArgumentException>(
            () => MavlinkFrame.Create(default(SetupSigning), 1, 1, 0, MavlinkVersion.V1));

        Assert.Contains("SetupSigning has id 256", fault.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(3)]
    public void Create_NoSuchVersion_Throws(int version) =>
        Assert.Throws<ArgumentOutOfRangeException>(
            nameof(version), () => MavlinkFrame.Create(Sample, 1, 1, 0, (MavlinkVersion)version));

    [Fact]
    public void TryDecode_OtherMessage_IsFalse()
    {
        Assert.False(MavlinkFrame.Create(Sample, 1, 1, 0).TryDecode(out Attitude attitude));
        Assert.Equal(0f, attitude.Roll);
    }

    [Fact]
    public void Default_IsNoFrame()
    {
        MavlinkFrame frame = default;

        Assert.Equal((MavlinkVersion.None, 0), (frame.Version, frame.WireLength));
        Assert.False(frame.TryDecode(out Heartbeat _));
        Assert.Equal(0, frame.WriteTo([]));
        Assert.Equal("no frame", frame.ToString());
    }

    [Fact]
    public void WriteTo_SpanTooShort_SaysHowMuchIsNeeded()
    {
        MavlinkFrame frame = MavlinkFrame.Create(Sample, 1, 1, 0);

        var fault = Assert.Throws<ArgumentException>(
            "destination", () => frame.WriteTo(new byte[frame.WireLength - 1]));

        Assert.Contains("20 bytes, 21 are needed", fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Payload_ReadByteByByteAndCopied_IsTheSame()
    {
        MavlinkFrame frame = MavlinkFrame.Create(Sample, 1, 1, 0);
        var copy = new byte[9];

        Assert.Equal(9, frame.CopyPayloadTo(copy));
        Assert.Equal(copy, Enumerable.Range(0, 9).Select(frame.PayloadByte));
        Assert.Equal(0, frame.PayloadByte(9));
        Assert.Equal(0, frame.PayloadByte(254));
        Assert.Throws<ArgumentOutOfRangeException>("index", () => frame.PayloadByte(255));
        Assert.Throws<ArgumentOutOfRangeException>("index", () => frame.PayloadByte(-1));
        Assert.Throws<ArgumentException>("destination", () => frame.CopyPayloadTo(new byte[8]));
    }

    [Fact]
    public void Payload_EachVersion_IsWhatCopyPayloadToCopies()
    {
        foreach (MavlinkVersion version in new[] { MavlinkVersion.V1, MavlinkVersion.V2 })
        {
            MavlinkFrame frame = MavlinkFrame.Create(Sample, 1, 1, 0, version);
            var copy = new byte[frame.PayloadLength];
            frame.CopyPayloadTo(copy);
            Assert.Equal(copy, frame.Payload.ToArray());
        }

        MavlinkFrame none = default;
        Assert.Equal(0, none.Payload.Length);
    }

    [Fact]
    public void TryRead_NoFrameIntoAnOldFrame_IsNoFrameInEveryMember()
    {
        var reader = new MavlinkFrameReader(MavlinkDialect.All);
        ReadOnlySpan<byte> bytes = Wire.V2(
            0, [1, 2, 3, 4, 5, 6, 7, 8, 9], Wire.Info<Heartbeat>().CrcExtra, incompatibilityFlags: 1);
        Assert.True(reader.TryRead(ref bytes, out MavlinkFrame frame, out MavlinkFrameInfo info));
        bytes = new byte[] { 0xFD };
        Assert.False(reader.TryRead(ref bytes, out frame, out info));
        bytes = new byte[] { 9 };
        Assert.False(reader.TryRead(ref bytes, out frame, out info));

        Assert.Equal(
            (MavlinkVersion.None, 0, 0, 0), (frame.Version, frame.WireLength, frame.PayloadLength, frame.MessageId));
        Assert.Equal((0, 0, 0, 0), (frame.SystemId, frame.ComponentId, frame.Sequence, frame.Checksum));
        Assert.Equal(
            (0, 0, false, 0L),
            (frame.IncompatibilityFlags, frame.SignatureLinkId, frame.IsSigned, frame.SignatureTimestamp));
        Assert.All(Enumerable.Range(0, 255), index => Assert.Equal(0, frame.PayloadByte(index)));
        Assert.False(frame.TryDecode(out Heartbeat _));
        Assert.Null(info.Message.Name);
    }

    [Fact]
    public void WithSequence_WithoutCrcExtra_GivesTheSameOfEveryGoldenFrame()
    {
        foreach (GoldenVector vector in GoldenVectors.All)
        {
            foreach (byte[]? wire in new[] { vector.V2, vector.V2Signed, vector.V1 })
            {
                if (wire is null)
                    continue;
                MavlinkFrame frame = Wire.Single(wire, out MavlinkFrameInfo info);
                byte crcExtra = info.Message.CrcExtra;
                Assert.Equal(Wire.Bytes(frame.WithSequence(77, crcExtra)), Wire.Bytes(frame.WithSequence(77)));
                Assert.Equal(Wire.Bytes(frame.WithoutSignature(crcExtra)), Wire.Bytes(frame.WithoutSignature()));
            }
        }
    }

    [Fact]
    public void WithSequence_WrongChecksumOrNoFrame_Throws()
    {
        // Of an unknown id, which a reader cannot check: of 65536 checksums all but 256 are found out.
        MavlinkFrame wrong = Wire.Single(
            [0xFD, 1, 0, 0, 0, 1, 1, 0x34, 0x12, 0x56, 7, 0xAA, 0x55], out MavlinkFrameInfo info);
        Assert.False(info.IsChecked);

        Assert.Throws<InvalidOperationException>(() => wrong.WithSequence(1));
        Assert.Throws<InvalidOperationException>(() => default(MavlinkFrame).WithSequence(1));
        Assert.Equal(MavlinkVersion.None, default(MavlinkFrame).WithoutSignature().Version);
    }

    [Fact]
    public void CopySignatureTo_SignedAndUnsigned_GivesThirteenBytesOrNone()
    {
        MavlinkFrame signed = Wire.Single(
            Wire.V2(0, [1], Wire.Info<Heartbeat>().CrcExtra, incompatibilityFlags: 1), out _);
        var signature = new byte[13];

        Assert.Equal(13, signed.CopySignatureTo(signature));
        Assert.All(signature, value => Assert.Equal(0x5A, value));
        Assert.Equal(0, MavlinkFrame.Create(Sample, 1, 1, 0).CopySignatureTo(signature));
    }

    [Fact]
    public void Target_FieldPresentCutOrAbsent_IsReadOrZero()
    {
        MavlinkMessageInfo command = Wire.Info<CommandLong>();
        MavlinkMessageInfo heartbeat = Wire.Info<Heartbeat>();
        MavlinkFrame addressed = MavlinkFrame.Create(
            new CommandLong { TargetSystem = 3, TargetComponent = 4 }, 1, 1, 0);
        MavlinkFrame cut = MavlinkFrame.Create(default(CommandLong), 1, 1, 0);
        MavlinkFrame broadcast = MavlinkFrame.Create(Sample, 1, 1, 0);

        Assert.Equal((3, 4), (addressed.TargetSystem(command), addressed.TargetComponent(command)));
        Assert.Equal((0, 0), (cut.TargetSystem(command), cut.TargetComponent(command)));
        Assert.Equal((0, 0), (broadcast.TargetSystem(heartbeat), broadcast.TargetComponent(heartbeat)));
        Assert.Equal((0, 0), (broadcast.TargetSystem(default), broadcast.TargetComponent(command)));
    }

    [Theory]
    [InlineData(MavlinkVersion.V1)]
    [InlineData(MavlinkVersion.V2)]
    public void WithSequence_Unsigned_GivesWhatCreateGives(MavlinkVersion version)
    {
        MavlinkFrame renumbered = MavlinkFrame.Create(Sample, 1, 191, 5, version)
            .WithSequence(6, Wire.Info<Heartbeat>().CrcExtra);

        Assert.Equal(Wire.Bytes(MavlinkFrame.Create(Sample, 1, 191, 6, version)), Wire.Bytes(renumbered));
    }

    [Fact]
    public void WithSequence_Signed_DropsTheSignature()
    {
        byte crcExtra = Wire.Info<Heartbeat>().CrcExtra;
        MavlinkFrame signed = Wire.Single(Wire.V2(0, [1], crcExtra, incompatibilityFlags: 1), out _);

        MavlinkFrame renumbered = signed.WithSequence(9, crcExtra);

        Assert.Equal(Wire.V2(0, [1], crcExtra, sequence: 9), Wire.Bytes(renumbered));
        Assert.Equal(0, renumbered.CopySignatureTo(new byte[13]));
    }

    [Fact]
    public void Size_IsThatOfItsBytesNearly()
        => Assert.InRange(Marshal.SizeOf<MavlinkFrame>(), MavlinkFrame.MaxWireLength, 288);

    [Fact]
    public void ToString_NamesIdSourceAndSequence() =>
        Assert.Equal("MAVLink 2 id 0 from 1/191 seq 17, 9 bytes", MavlinkFrame.Create(Sample, 1, 191, 17).ToString());
}
