using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Signed links, beside links that are not.</summary>
public sealed class SigningTests : IDisposable
{
    private static readonly DateTimeOffset Start = new(2026, 1, 1, 0, 0, 0, TimeSpan.Zero);

    private readonly MavlinkSigningKey _key = MavlinkSigningKey.FromPassphrase("only we two know it");
    private readonly MavlinkSigningClock _clock = new();
    private byte _sequence;

    public SigningTests() => _clock.Advance(Start.UtcDateTime, TimeSpan.Zero);

    public void Dispose() => _key.Dispose();

    [Fact]
    public void OwnFrames_SignedLink_AreSignedWithItsLinkId_OtherLinkNot()
    {
        using CommunicationsRig rig = Rig(3, o => (o.Links, o.FirstLinkId) = ([0, 2], 7));
        for (int i = 0; i < 3; i++)
            rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });

        var verifier = new MavlinkVerifier(_key, new MavlinkSigningClock());
        foreach (int link in new[] { 0, 2 })
        {
            List<MavlinkFrame> frames = rig.ReceivedFrames(link);
            Assert.Equal(3, frames.Count);
            Assert.All(frames, f => Assert.True(
                verifier.Verify(f) is MavlinkSignatureResult.Valid or MavlinkSignatureResult.ValidNewStream));
            Assert.All(frames, f => Assert.Equal(7 + link, f.SignatureLinkId));
        }

        Assert.All(rig.ReceivedFrames(1), f => Assert.False(f.IsSigned));
    }

    [Fact]
    public void FramesIn_SignedLink_OnlyProvedOnesAreHandedOverAndForwarded()
    {
        using CommunicationsRig rig = Rig(2, o => o.Links = [0]);
        byte[] good = Signed(_key);
        using MavlinkSigningKey other = MavlinkSigningKey.FromPassphrase("another");
        rig.Send(
            0, good, Frames.Heartbeat(sequence: 50), Signed(other), good,
            Frames.Of(new RadioStatus { Rssi = 3 }, 51, 68));

        Assert.Equal([Heartbeat.MavlinkId, RadioStatus.MavlinkId], rig.Autopilot.Taken.Select(f => f.Frame.MessageId));
        Assert.Equal(Frames.Hex(good), Frames.Hex(rig.Received(1)));
        LinkStatus status = rig.Status(0);
        MavlinkSignatureCounters counts = status.Signatures;
        Assert.Equal((5L, 1L, 1L), (status.FramesIn, counts.Valid, counts.UnsignedAllowed));
        Assert.Equal((1L, 1L, 1L, 3L), (counts.NotSigned, counts.BadSignatures, counts.OldTimestamps, counts.Rejected));
        Assert.Equal(0, rig.Status(1).Signatures.Rejected);
        Assert.Contains(rig.Log, e => e.Text.Contains(
            "link 0: 3 frames were rejected; since the start 1 not signed, 1 with a bad signature, 1 too old"));
    }

    [Fact]
    public void FramesRejected_WithoutEnd_AreReportedWhenTheyHaveDoubled()
    {
        using CommunicationsRig rig = Rig(1, o => o.Links = [0]);
        for (int i = 0; i < 100; i++)
        {
            rig.Send(0, Frames.Heartbeat(sequence: (byte)i));
            rig.Run(TimeSpan.FromSeconds(1));
        }

        Assert.Equal(100, rig.Status(0).Signatures.Rejected);
        Assert.InRange(rig.Log.Count(e => e.Text.Contains("frames were rejected")), 2, 8);
    }

    [Fact]
    public void Forwarded_ToASignedLink_KeepsItsOwnSignatureOrNone()
    {
        using CommunicationsRig rig = Rig(2, o => o.Links = [1]);
        byte[] signed = Signed(_key);
        byte[] unsigned = Frames.Heartbeat(sequence: 9);
        rig.Send(0, signed, unsigned);
        Assert.Equal(Frames.Hex(Frames.Join([signed, unsigned])), Frames.Hex(rig.Received(1)));
    }

    [Fact]
    public void RejectedFrame_TeachesTheRouterNothing()
    {
        using CommunicationsRig rig = Rig(2, o => o.Links = [0]);
        rig.Send(0, Frames.Heartbeat(system: 9));
        rig.SendOwn(Frames.Command(9, 1));
        Assert.Empty(rig.Received(0));
    }

    [Fact]
    public void UnsignedRule_DecidesByLinkAndFrame()
    {
        using CommunicationsRig rig = Rig(2, o => o.AcceptUnsigned = (in MavlinkFrame frame, int link) => link == 1);
        rig.Send(0, Frames.Heartbeat());
        rig.Send(1, Frames.Heartbeat(sequence: 1));
        Assert.Equal(1, Assert.Single(rig.Autopilot.Taken).Link);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void SetupSigning_IsNeverForwarded(bool isSigned)
    {
        using CommunicationsRig rig = Rig(3, o => o.Links = [0, 1]);
        rig.Send(0, Signed(_key));
        rig.Received(1);
        rig.Received(2);
        rig.Autopilot.Taken.Clear();
        MavlinkFrame setup = MavlinkFrame.Create(_key.CreateSetup(1, 1, 0), 255, 190, 0);
        rig.Send(1, Frames.Bytes(isSigned ? Sign(setup, SetupSigning.MavlinkCrcExtra, _key) : setup));
        rig.Send(2, Frames.Bytes(setup));
        Assert.Empty(rig.Received(0));
        Assert.Empty(rig.Received(1));
        Assert.Empty(rig.Received(2));
        Assert.Empty(rig.Autopilot.Taken);
    }

    [Fact]
    public void Clock_IsStoredAndARestartGoesOn()
    {
        var store = new MemoryTimestamps();
        MavlinkFrame last;
        using (CommunicationsRig rig = Rig(1, o => o.TimestampStore = store))
        {
            rig.Run(TimeSpan.FromSeconds(100));
            Assert.Equal(4, store.Writes);
            rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });
            last = rig.ReceivedFrames(0).Last();
        }

        // The wall clock of this one is where the first one's began.
        using CommunicationsRig next = Rig(1, o => o.TimestampStore = store);
        next.SendOwn(new Heartbeat { MavlinkVersion = 3 });
        MavlinkFrame first = next.ReceivedFrames(0).First();
        Assert.InRange(first.SignatureTimestamp - last.SignatureTimestamp, 1, MavlinkSigningClock.TicksPerSecond);
    }

    [Fact]
    public void Clock_CannotBeStored_IsSaidAndTriedAgain()
    {
        var store = new MemoryTimestamps { IsBroken = true };
        using CommunicationsRig rig = Rig(1, o => o.TimestampStore = store);
        rig.Run(TimeSpan.FromSeconds(32));
        Assert.Single(rig.Log, e => e.Text.Contains("could not be stored"));
        store.IsBroken = false;
        rig.Run(TimeSpan.FromSeconds(3));
        Assert.Equal(2, store.Writes);   // the first is trusted once the second was tried
        rig.Run(TimeSpan.FromSeconds(20));
        Assert.Equal(2, store.Writes);
    }

    [Fact]
    public void Options_OutOfTheirRange_AreRefusedByName()
    {
        ArgumentException e = Assert.Throws<ArgumentException>(
            () => Rig(2, o => (o.Links, o.FirstLinkId, o.AcceptUnsigned) = ([0, 2], 255, null!)).Dispose());
        Assert.Contains("link 2 is to be signed, but there are 2 live links", e.Message);
        Assert.Contains("FirstLinkId is 255", e.Message);
        Assert.Contains("AcceptUnsigned is null", e.Message);
        Assert.Throws<ArgumentNullException>(() => new SigningOptions(null!));
    }

    private CommunicationsRig Rig(int links, Action<SigningOptions> configure)
    {
        void Configure(CommunicationsOptions options)
        {
            options.Signing = new SigningOptions(_key);
            options.PositionRateHz = 0;
            configure(options.Signing);
        }

        return new CommunicationsRig(links, Configure, startUtc: Start).As(1);
    }

    private byte[] Signed(MavlinkSigningKey key)
        => Frames.Bytes(
            Sign(Frames.Read(Frames.Heartbeat(sequence: _sequence++)).Single(), Heartbeat.MavlinkCrcExtra, key));

    private MavlinkFrame Sign(in MavlinkFrame frame, byte crcExtra, MavlinkSigningKey key)
        => new MavlinkSigner(key, 3, _clock).Sign(frame, crcExtra);
}
