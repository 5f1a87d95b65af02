using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Frames that other managers want sent.</summary>
public sealed class OwnFramesTests
{
    [Fact]
    public void Broadcast_GoesToEveryLink()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 3).As(1);

        rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });

        for (int link = 0; link < 3; link++)
            Assert.Equal((1, 191, Heartbeat.MavlinkId), Source(Assert.Single(rig.ReceivedFrames(link))));
        Assert.Empty(rig.Autopilot.Taken);
    }

    [Fact]
    public void Expired_IsNotSentAndCountsAsDropped()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 1).As(1);
        rig.Run(TimeSpan.FromSeconds(3));
        var frame = MavlinkFrame.Create(new Heartbeat { MavlinkVersion = 3 }, 1, 191, sequence: 0);

        rig.SendOwn(frame, validUntil: rig.Reactor.Now - TimeSpan.FromSeconds(1));
        Assert.Empty(rig.ReceivedFrames(0));
        rig.SendOwn(frame, validUntil: rig.Reactor.Now + TimeSpan.FromSeconds(1));
        Assert.Single(rig.ReceivedFrames(0));
    }

    [Fact]
    public void Sequence_OfEachSender_IsConsecutiveAndWraps()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 1).As(1);
        var frames = new List<MavlinkFrame>();

        for (int n = 0; n < 300; n++)
        {
            rig.SendOwn(new Heartbeat { MavlinkVersion = 3 }, component: 191);
            if (n % 3 == 0)
                rig.SendOwn(new Heartbeat { MavlinkVersion = 3 }, component: 100);
            frames.AddRange(rig.ReceivedFrames(0));
        }

        Assert.Equal(
            Enumerable.Range(0, 300).Select(n => (byte)n),
            frames.Where(f => f.ComponentId == 191).Select(f => f.Sequence));
        Assert.Equal(
            Enumerable.Range(0, 100).Select(n => (byte)n),
            frames.Where(f => f.ComponentId == 100).Select(f => f.Sequence));
    }

    [Fact]
    public void Sequence_OfOneLink_HasNoGapForWhatWentToOthers()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);
        rig.Send(1, Frames.Heartbeat(system: 7));
        rig.Received(0);

        rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });
        rig.SendOwn(Frames.Command(7, 1));
        rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });

        Assert.Equal(new byte[] { 0, 1 }, rig.ReceivedFrames(0).Select(f => f.Sequence));
        Assert.Equal(new byte[] { 0, 1, 2 }, rig.ReceivedFrames(1).Select(f => f.Sequence));
    }

    [Fact]
    public void Addressed_TargetNeverSeen_GoesNowhereButIsCounted()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);

        rig.SendOwn(Frames.Command(7, 1));

        Assert.Empty(rig.Received(0));
        Assert.Empty(rig.Received(1));
        Assert.Equal(1, Assert.Single(rig.Manager.CountOwnFrames()).Count);
    }

    [Fact]
    public void SetupSigning_Broadcast_GoesNowhere()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 1).As(1);

        rig.SendOwn(default(SetupSigning));

        Assert.Empty(rig.Received(0));
    }

    [Fact]
    public void UnknownId_IsNotSentAndTheLogSaysSo()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 1).As(1);
        MavlinkFrame unknown = Frames.Read(Frames.Raw(Frames.UnknownId, [1, 2, 3])).Single();

        rig.SendOwn(unknown);

        Assert.Empty(rig.Received(0));
        Assert.Contains(rig.Log, e => e.Text.Contains("is not sent: the dialect does not know its id"));
    }

    [Fact]
    public void Counts_OfOwnFrames_AreApartFromThoseOfTheLinks()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);
        rig.Send(0, Frames.Heartbeat(sequence: 10), Frames.Heartbeat(sequence: 13));
        rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });
        rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });

        FrameCount own = Assert.Single(rig.Manager.CountOwnFrames());
        Assert.Equal((1, 191, "HEARTBEAT", 2L), (own.SystemId, own.ComponentId, own.Name, own.Count));
        LinkSummary link = rig.Manager.SummariseLinks()[0];
        FrameCount came = Assert.Single(link.Counts);
        Assert.Equal((1, 1, 2L), (came.SystemId, came.ComponentId, came.Count));
        Assert.Equal(2, Assert.Single(link.Sources).Missing);
        Assert.Empty(rig.Manager.SummariseLinks()[1].Counts);
        Assert.Equal((2L, 2L, 2L), (rig.Status(0).FramesIn, rig.Status(0).FramesOut, rig.Status(0).FramesMissing));
        Assert.Equal((0L, 4L), (rig.Status(1).FramesIn, rig.Status(1).FramesOut));
    }

    private static (int System, int Component, int Message) Source(MavlinkFrame frame)
        => (frame.SystemId, frame.ComponentId, frame.MessageId);
}
