using System;
using System.Reflection;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests.Framing;
using Rabit.Mavlink.Tests.Golden;
using Rabit.Mavlink.Tests.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Signing;

public class MavlinkSignerTests
{
    private delegate byte[] Remake(in MavlinkFrame frame, MavlinkSigner signer);

    [Fact]
    public void Sign_EveryGoldenLine_GivesTheListedBytes()
    {
        foreach (GoldenVector vector in GoldenVectors.All)
        {
            MavlinkFrame unsigned = Wire.Single(vector.V2, out MavlinkFrameInfo info);
            MavlinkFrame signed = SignerOf(vector).Sign(unsigned, info.Message.CrcExtra);

            Assert.True(vector.V2Signed.AsSpan().SequenceEqual(Wire.Bytes(signed)), vector.ToString());
            Assert.True(
                vector.V2Signed.AsSpan().SequenceEqual(Wire.Bytes(SignerOf(vector).Sign(unsigned))), vector.ToString());
            Assert.True(
                vector.V2.AsSpan().SequenceEqual(Wire.Bytes(signed.WithoutSignature(info.Message.CrcExtra))),
                vector.ToString());
        }
    }

    [Fact]
    public void SenderWrite_EveryGoldenLine_GivesTheListedBytes()
    {
        foreach (GoldenVector vector in GoldenVectors.All)
        {
            if (vector.SystemId == 0 || vector.ComponentId == 0)
                continue;
            MavlinkFrame frame = Wire.Single(vector.V2, out _);
            byte[] written = RemakeOf(MessageTypes.ById[vector.Id])(frame, SignerOf(vector));

            // A sender counts from 0, and the lines do not: the sequence number is put right, and the bytes that depend
            // on it are left out.
            Assert.Equal(vector.V2Signed.Length, written.Length);
            MavlinkFrame.FromWire(written, out MavlinkFrame signed);
            using MavlinkSigningKey key = Keys.Of(vector.Signing.GetProperty("key"));
            Assert.True(key.Matches(signed), vector.ToString());
            Assert.Equal(vector.Signing.GetProperty("timestamp").GetInt64(), signed.SignatureTimestamp);
        }
    }

    [Fact]
    public void Sign_ManyInOneMoment_GivesLaterAndLaterTimes()
    {
        var signer = new MavlinkSigner(Keys.One, 9, Keys.ClockAt(Keys.Noon));
        for (int frame = 0; frame < 5; frame++)
        {
            MavlinkFrame signed = signer.Sign(Keys.Unsigned(), Heartbeat.MavlinkCrcExtra);
            Assert.Equal((Keys.Noon + frame, (byte)9), (signed.SignatureTimestamp, signed.SignatureLinkId));
        }

        Assert.Equal(5, signer.Frames);
    }

    [Fact]
    public void Sign_ASignedFrame_ReplacesTheSignature()
    {
        MavlinkFrame first = Keys.Signed(Keys.Noon, Keys.Of(50), linkId: 4);
        var signer = new MavlinkSigner(Keys.One, 1, Keys.ClockAt(Keys.Noon));

        Assert.Equal(
            Wire.Bytes(Keys.Signed(Keys.Noon, linkId: 1)), Wire.Bytes(signer.Sign(first, Heartbeat.MavlinkCrcExtra)));
    }

    [Fact]
    public void Sign_Mavlink1_IsRefused()
    {
        MavlinkFrame frame = MavlinkFrame.Create(default(Heartbeat), 1, 1, 0, MavlinkVersion.V1);
        var signer = new MavlinkSigner(Keys.One, 1, Keys.ClockAt(Keys.Noon));

        Assert.Throws<ArgumentException>(() => signer.Sign(frame, Heartbeat.MavlinkCrcExtra));
        Assert.Throws<ArgumentException>(() => signer.Sign(default, Heartbeat.MavlinkCrcExtra));
        Assert.Equal(0, signer.Frames);
    }

    [Fact]
    public void Sign_ClockThatWasNeverAdvanced_IsRefused()
    {
        var signer = new MavlinkSigner(Keys.One, 1, new MavlinkSigningClock());

        Assert.Throws<InvalidOperationException>(() => signer.Sign(Keys.Unsigned(), Heartbeat.MavlinkCrcExtra));
    }

    [Fact]
    public void New_WithoutKeyOrClock_IsRefused()
    {
        Assert.Throws<ArgumentNullException>(() => new MavlinkSigner(null!, 0, new MavlinkSigningClock()));
        Assert.Throws<ArgumentNullException>(() => new MavlinkSigner(Keys.One, 0, null!));
    }

    private static MavlinkSigner SignerOf(GoldenVector vector)
    {
        var clock = new MavlinkSigningClock(vector.Signing.GetProperty("timestamp").GetInt64());
        Keys.Set(clock, 0);
        return new MavlinkSigner(
            Keys.Of(vector.Signing.GetProperty("key")), vector.Signing.GetProperty("link_id").GetByte(), clock);
    }

    private static Remake RemakeOf(Type message) => (Remake)Delegate.CreateDelegate(
        typeof(Remake),
        typeof(MavlinkSignerTests).GetMethod(nameof(DecodeAndSend), BindingFlags.NonPublic | BindingFlags.Static)!
            .MakeGenericMethod(message));

    private static byte[] DecodeAndSend<T>(in MavlinkFrame frame, MavlinkSigner signer)
        where T : struct, IMavlinkMessage
    {
        Assert.True(frame.TryDecode(out T message));
        var sender = new MavlinkSender(frame.SystemId, frame.ComponentId) { Signer = signer };
        var buffer = new byte[MavlinkFrame.MaxWireLength];
        int length = sender.Write(message, buffer.AsSpan());
        return buffer.AsSpan(0, length).ToArray();
    }
}
