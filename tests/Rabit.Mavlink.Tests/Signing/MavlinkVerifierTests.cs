using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests.Framing;
using Xunit;

namespace Rabit.Mavlink.Tests.Signing;

public class MavlinkVerifierTests
{
    private readonly MavlinkSigningClock _clock = Keys.ClockAt(Keys.Noon);
    private readonly MavlinkVerifier _verifier;

    public MavlinkVerifierTests() => _verifier = new MavlinkVerifier(Keys.One, _clock);

    [Fact]
    public void Verify_SignedStream_AcceptsAndRejectsAsListed()
    {
        byte[] bytes = TestData.Bytes("d-signed.bin");
        using JsonDocument facts = TestData.Json(TestData.PathOf("d-signed.json"));
        JsonElement receiver = facts.RootElement.GetProperty("receiver");
        using MavlinkSigningKey key = Keys.Of(receiver.GetProperty("key"));
        long start = receiver.GetProperty("clock_ticks_at_start").GetInt64();
        MavlinkSigningClock clock = Keys.ClockAt(start);
        var verifier = new MavlinkVerifier(key, clock);
        Dictionary<long, MavlinkFrame> found = FrameCollector.Read(
            bytes, bytes.Length, new MavlinkFrameReader(MavlinkDialect.All))
            .ToDictionary(frame => frame.Info.StreamOffset, frame => frame.Frame);

        int listed = 0;
        foreach (JsonElement row in facts.RootElement.GetProperty("frames").EnumerateArray())
        {
            long now = row.GetProperty("clock_ticks").GetInt64();
            clock.Advance(MavlinkSigningClock.ToUtc(now), TimeSpan.FromTicks((now - start) * 100));
            Assert.Equal(row.GetProperty("signing_ticks_before").GetInt64(), clock.Timestamp);

            // A wrong checksum never comes as far as the verifier.
            string result = found.TryGetValue(row.GetProperty("offset").GetInt64(), out MavlinkFrame frame)
                ? TextOf(verifier.Verify(frame))
                : "reject bad_checksum";
            string[] reasons = [.. row.GetProperty("reasons_all").EnumerateArray()
                .Select(reason => $"{row.GetProperty("action")} {reason}")];
            Assert.True(
                reasons.Contains(result, StringComparer.Ordinal),
                $"frame {row.GetProperty("i")}: {result}, listed {string.Join(" or ", reasons)}");
            listed++;
        }

        Assert.Equal(500, listed);
        MavlinkSignatureCounters counters = verifier.Counters;
        Assert.Equal(
            (369, 12, 12, 48), (counters.Valid, counters.UnsignedAllowed, counters.NotSigned, counters.BadSignatures));
        Assert.Equal((40, 13, 0), (counters.OldTimestamps, counters.NewStreamsTooOld, counters.TooManyStreams));
        Assert.Equal(29, verifier.Streams);
    }

    [Fact]
    public void Verify_SameFrameTwice_RejectsTheSecond()
    {
        MavlinkFrame frame = Keys.Signed(Keys.Noon);

        Assert.Equal(MavlinkSignatureResult.ValidNewStream, _verifier.Verify(frame, link: 0));
        Assert.Equal(MavlinkSignatureResult.OldTimestamp, _verifier.Verify(frame, link: 1));
        Assert.Equal(MavlinkSignatureResult.Valid, _verifier.Verify(Keys.Signed(Keys.Noon + 1)));
    }

    [Theory]
    [InlineData(2, 1, 0)]
    [InlineData(1, 2, 0)]
    [InlineData(1, 1, 2)]
    public void Verify_AnotherSystemComponentOrLink_IsAnotherStream(byte systemId, byte componentId, byte linkId)
    {
        _verifier.Verify(Keys.Signed(Keys.Noon));

        Assert.Equal(
            MavlinkSignatureResult.ValidNewStream,
            _verifier.Verify(Keys.Signed(Keys.Noon - 10, null, systemId, componentId, linkId)));
        Assert.Equal(2, _verifier.Streams);
    }

    [Fact]
    public void Verify_NewStreamOneMinuteBehind_IsAcceptedAndOneTickMoreIsNot()
    {
        Assert.Equal(MavlinkSignatureResult.ValidNewStream, _verifier.Verify(Keys.Signed(Keys.Noon - 6_000_000)));
        Assert.Equal(
            MavlinkSignatureResult.NewStreamTooOld, _verifier.Verify(Keys.Signed(Keys.Noon - 6_000_001, systemId: 2)));
        Assert.Equal(1, _verifier.Streams);
    }

    [Fact]
    public void Verify_FrameFromTheFuture_MovesTheClock()
    {
        _verifier.Verify(Keys.Signed(Keys.Noon + 30_000_000));

        Assert.Equal(Keys.Noon + 30_000_000, _clock.Timestamp);
        Assert.Equal(MavlinkSignatureResult.NewStreamTooOld, _verifier.Verify(Keys.Signed(Keys.Noon, systemId: 2)));
    }

    [Fact]
    public void Verify_ForgedFrameFromTheFuture_ChangesNothing()
    {
        using MavlinkSigningKey wrong = Keys.Of(66);
        Assert.Equal(MavlinkSignatureResult.BadSignature, _verifier.Verify(Keys.Signed(Keys.Noon + 30_000_000, wrong)));

        Assert.Equal((Keys.Noon, 0), (_clock.Timestamp, _verifier.Streams));
        Assert.Equal(MavlinkSignatureResult.ValidNewStream, _verifier.Verify(Keys.Signed(Keys.Noon)));
    }

    [Fact]
    public void Verify_MoreStreamsThanThereIsRoomFor_RejectsTheNewOnesAndKeepsTheOld()
    {
        var verifier = new MavlinkVerifier(Keys.One, _clock, maxStreams: 2);
        verifier.Verify(Keys.Signed(Keys.Noon));
        verifier.Verify(Keys.Signed(Keys.Noon, systemId: 2));

        Assert.Equal(MavlinkSignatureResult.TooManyStreams, verifier.Verify(Keys.Signed(Keys.Noon, systemId: 3)));
        Assert.Equal(MavlinkSignatureResult.Valid, verifier.Verify(Keys.Signed(Keys.Noon + 1, systemId: 2)));
        Assert.Equal((3, 1), (verifier.Counters.Valid, verifier.Counters.TooManyStreams));
    }

    [Fact]
    public void Verify_EveryStreamThereIs_RemembersEachOfThem()
    {
        var verifier = new MavlinkVerifier(Keys.One, _clock, maxStreams: 2000);
        for (int round = 0; round < 2; round++)
        {
            for (int stream = 0; stream < 2000; stream++)
            {
                MavlinkFrame frame = Keys.Signed(
                    Keys.Noon + round, null, (byte)(1 + (stream % 200)), 1, (byte)(stream / 200));
                Assert.Equal(
                    round == 0 ? MavlinkSignatureResult.ValidNewStream : MavlinkSignatureResult.Valid,
                    verifier.Verify(frame));
                Assert.Equal(MavlinkSignatureResult.OldTimestamp, verifier.Verify(frame));
            }
        }
    }

    [Fact]
    public void Verify_Unsigned_OnlyRadioStatusPasses()
    {
        Assert.Equal(MavlinkSignatureResult.NotSigned, _verifier.Verify(Keys.Unsigned()));
        Assert.Equal(
            MavlinkSignatureResult.UnsignedAllowed,
            _verifier.Verify(MavlinkFrame.Create(default(RadioStatus), 51, 68, 0)));
        Assert.Equal(MavlinkSignatureResult.NotSigned, _verifier.Verify(default));
        Assert.Equal((2, 1), (_verifier.Counters.NotSigned, _verifier.Counters.UnsignedAllowed));
    }

    [Fact]
    public void Verify_UnsignedWithARuleOfOnesOwn_AsksItWithTheLink()
    {
        var verifier = new MavlinkVerifier(
            Keys.One, _clock, (in MavlinkFrame frame, int link) => link == 3 && frame.SystemId == 1);

        Assert.Equal(MavlinkSignatureResult.UnsignedAllowed, verifier.Verify(Keys.Unsigned(), link: 3));
        Assert.Equal(MavlinkSignatureResult.NotSigned, verifier.Verify(Keys.Unsigned(), link: 2));
        Assert.Equal(MavlinkSignatureResult.NotSigned, verifier.Verify(Keys.Unsigned(systemId: 2), link: 3));
        Assert.Equal((0, Keys.Noon), (verifier.Streams, _clock.Timestamp));
    }

    [Fact]
    public void Verify_SignedWithTheWrongKey_NeverReachesTheRuleForUnsigned()
    {
        using MavlinkSigningKey wrong = Keys.Of(66);
        var verifier = new MavlinkVerifier(Keys.One, _clock, (in MavlinkFrame _, int _) => true);

        Assert.Equal(MavlinkSignatureResult.BadSignature, verifier.Verify(Keys.Signed(Keys.Noon, wrong)));
    }

    [Fact]
    public void Verify_UnknownIdRightlySigned_IsAccepted()
    {
        // The checksum of an unknown id cannot be checked; the signature covers it.
        MavlinkFrame frame = Wire.Single(Wire.V2(Wire.UnknownId, [1, 2, 3], crcExtra: 99), out _);
        MavlinkFrame signed = new MavlinkSigner(Keys.One, 0, _clock).Sign(frame, crcExtra: 99);

        Assert.Equal(MavlinkSignatureResult.ValidNewStream, _verifier.Verify(signed));
    }

    [Fact]
    public void New_WithoutKeyClockOrRoom_IsRefused()
    {
        Assert.Throws<ArgumentNullException>(() => new MavlinkVerifier(null!, _clock));
        Assert.Throws<ArgumentNullException>(() => new MavlinkVerifier(Keys.One, null!));
        Assert.Throws<ArgumentOutOfRangeException>(() => new MavlinkVerifier(Keys.One, _clock, null, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new MavlinkVerifier(Keys.One, _clock, null, 65_537));
    }

    [Theory]
    [InlineData(MavlinkSignatureResult.Valid, true)]
    [InlineData(MavlinkSignatureResult.ValidNewStream, true)]
    [InlineData(MavlinkSignatureResult.UnsignedAllowed, true)]
    [InlineData(MavlinkSignatureResult.NotSigned, false)]
    [InlineData(MavlinkSignatureResult.BadSignature, false)]
    [InlineData(MavlinkSignatureResult.OldTimestamp, false)]
    [InlineData(MavlinkSignatureResult.NewStreamTooOld, false)]
    [InlineData(MavlinkSignatureResult.TooManyStreams, false)]
    public void IsAccepted_EachResult_IsAsDocumented(MavlinkSignatureResult result, bool expected)
        => Assert.Equal(expected, result.IsAccepted());

    private static string TextOf(MavlinkSignatureResult result) => result switch
    {
        MavlinkSignatureResult.Valid => "accept ok",
        MavlinkSignatureResult.ValidNewStream => "accept new_stream",
        MavlinkSignatureResult.UnsignedAllowed => "accept unsigned_allowed",
        MavlinkSignatureResult.NotSigned => "reject unsigned",
        MavlinkSignatureResult.BadSignature => "reject bad_signature",
        MavlinkSignatureResult.OldTimestamp => "reject old_timestamp",
        MavlinkSignatureResult.NewStreamTooOld => "reject new_stream_too_old",
        _ => ((int)result).ToString(CultureInfo.InvariantCulture),
    };
}
