using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>What happens on live links when there is no room: the oldest goes, and is counted.</summary>
public sealed class FullQueueTests
{
    [Fact]
    public void LiveLink_MoreFramesThanMayWait_DropsTheOldestAndCounts()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 1, o => o.FramesWaitingIn = 4).As(1);

        rig.Send(0, Burst(10));

        Assert.Equal(new byte[] { 6, 7, 8, 9 }, rig.Autopilot.Taken.Select(f => f.Frame.Sequence));
        Assert.Equal((10L, 6L), (rig.Status(0).FramesIn, rig.Status(0).FramesDroppedIn));
    }

    [Fact]
    public void LiveLink_MoreFramesToSendThanMayWait_SendsTheNewestAndCounts()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2, o => o.FramesWaitingOut = 4).As(1);

        rig.Send(0, Burst(10));

        Assert.Equal(new byte[] { 6, 7, 8, 9 }, rig.ReceivedFrames(1).Select(f => f.Sequence));
        Assert.Equal((4L, 6L), (rig.Status(1).FramesOut, rig.Status(1).FramesDroppedOut));
    }

    [Fact]
    public void Autopilot_QueueFull_LiveFramesAreDroppedAndCountedButStillForwarded()
    {
        var autopilot = new FakeAutopilot(capacity: 3) { AtMost = 0 };
        using CommunicationsRig rig = new CommunicationsRig(links: 2, autopilot: autopilot).As(1);

        rig.Send(0, Burst(10));

        Assert.Equal(10, rig.ReceivedFrames(1).Count);
        Assert.Equal((10L, 7L), (rig.Status(0).FramesIn, rig.Status(0).FramesDroppedIn));
        Assert.Equal(0, rig.Status(1).FramesDroppedIn);
    }

    [Fact]
    public void Link_ThatDropsAWriteByItself_CountsTheFrameAsDropped()
    {
        int room = 3 * Frames.Heartbeat().Length;
        using CommunicationsRig rig = new CommunicationsRig(links: 1, linkCapacity: room).As(1);

        for (int n = 0; n < 5; n++)
            rig.SendOwn(
                new Heartbeat { Type = MavType.Quadrotor, Autopilot = MavAutopilot.Ardupilotmega, MavlinkVersion = 3 });

        Assert.Equal(3, rig.ReceivedFrames(0).Count);
        Assert.Equal((3L, 2L), (rig.Status(0).FramesOut, rig.Status(0).FramesDroppedOut));
    }

    private static byte[][] Burst(int count)
        => Enumerable.Range(0, count).Select(n => Frames.Heartbeat(sequence: (byte)n)).ToArray();
}
