using System;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Copies of frames, and frames with an address that is another's.</summary>
public sealed class AddressTests
{
    [Fact]
    public void Copy_OverAnotherLink_GoesNowhereAndIsCounted()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 3).As(1);
        byte[] frame = Frames.Heartbeat(system: 7, sequence: 5);

        rig.Send(0, frame);
        rig.Send(1, frame);

        Assert.Single(rig.Autopilot.Taken);
        Assert.Single(rig.ReceivedFrames(2));
        Assert.Empty(rig.Received(0));
        Assert.Equal((0L, 1L), (rig.Status(0).FramesDuplicate, rig.LastStatus(1).FramesDuplicate));
        Assert.Equal(1, rig.LastStatus(1).FramesIn);
    }

    [Fact]
    public void Loop_OfTwoLinks_EndsAfterOneRound()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 3).As(1);
        int rounds = 0;
        rig.Send(0, Frames.Heartbeat(system: 7));

        // Links 1 and 2 are joined at their far ends.
        for (byte[] a, b; (a = rig.Received(1)).Length + (b = rig.Received(2)).Length > 0; rounds++)
        {
            Assert.True(rounds < 5, "the loop does not end");
            rig.Send(2, a);
            rig.Send(1, b);
        }

        Assert.Equal(1, rounds);
        Assert.Single(rig.Autopilot.Taken);
    }

    [Fact]
    public void Copy_TeachesWhereItsSenderIs()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 3).As(1);
        rig.Send(0, Frames.Heartbeat(system: 7));
        rig.Send(1, Frames.Heartbeat(system: 7));
        rig.Received(1);
        rig.Received(0);

        rig.Send(2, Frames.Of(Frames.Command(7, 1), 255, 190));

        Assert.Single(rig.ReceivedFrames(0));
        Assert.Single(rig.ReceivedFrames(1));
    }

    [Fact]
    public void CommandRepeated_WithAnotherSequenceNumber_IsNoCopy()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);
        rig.Send(1, Frames.Heartbeat(system: 7));

        rig.Send(0, Frames.Of(Frames.Command(7, 1), 255, 190, sequence: 1));
        rig.Send(0, Frames.Of(Frames.Command(7, 1), 255, 190, sequence: 2));

        Assert.Equal(2, rig.ReceivedFrames(1).Count);
    }

    [Fact]
    public void OwnFrame_ThatComesBack_IsACopyAndNoConflict()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);
        rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });
        byte[] sent = rig.Received(0);
        rig.Received(1);

        rig.Send(0, sent);

        Assert.Empty(rig.Received(1));
        Assert.Equal((1L, 0L), (rig.Status(0).FramesDuplicate, rig.LastStatus(0).AddressConflicts));
    }

    [Fact]
    public void Frame_WithOurAddressThatWeDidNotSend_GoesNowhereAndIsReported()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);

        rig.Send(0, Frames.Of(new Heartbeat { MavlinkVersion = 3 }, system: 1, component: 191, sequence: 77));

        Assert.Equal(1, rig.Status(0).AddressConflicts);
        Assert.DoesNotContain(rig.ReceivedFrames(1), f => f.MessageId == Heartbeat.MavlinkId);
        Assert.Empty(rig.Autopilot.Taken);
        Assert.Single(
            rig.Log, e => e.ToString().Contains("1 frames so far have our own address", StringComparison.Ordinal));
    }

    [Fact]
    public void AutopilotsAddress_OverAnotherLink_IsReportedAndUsed()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);
        rig.Post(new VehicleState { SystemId = 1, ComponentId = 1 });
        rig.Run(TimeSpan.FromSeconds(0.3));
        rig.Send(0, Frames.Heartbeat(sequence: 1));

        rig.Send(1, Frames.Heartbeat(sequence: 200));

        Assert.Equal((0L, 1L), (rig.Status(0).AddressConflicts, rig.LastStatus(1).AddressConflicts));
        Assert.Equal(2, rig.Autopilot.Taken.Count);
    }

    [Fact]
    public void AutopilotsAddress_OverAnotherLinkWhereItsOwnIsSilent_IsItsNewLink()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);
        rig.Post(new VehicleState { SystemId = 1, ComponentId = 1 });
        rig.Run(TimeSpan.FromSeconds(0.3));
        rig.Send(0, Frames.Heartbeat(sequence: 1));
        rig.Run(TimeSpan.FromSeconds(6));

        rig.Send(1, Frames.Heartbeat(sequence: 200));

        Assert.Equal(0, rig.Status(1).AddressConflicts);
    }

    [Theory]
    [InlineData(false, MavAutopilot.Invalid, 0)]
    [InlineData(true, MavAutopilot.Invalid, 1)]
    [InlineData(true, MavAutopilot.Ardupilotmega, 0)]
    public void RadioStatus_ByOption_GoesToGroundStationsOnly(bool isForwarded, MavAutopilot beside, int expected)
    {
        using CommunicationsRig rig = new CommunicationsRig(
            links: 2, o => o.ForwardsRadioStatus = isForwarded).As(1);
        rig.Send(1, Frames.Of(new Heartbeat { Type = MavType.Gcs, Autopilot = MavAutopilot.Invalid }, 255, 190));
        rig.Send(1, Frames.Of(new Heartbeat { Type = MavType.Quadrotor, Autopilot = beside }, 7));
        rig.Run(TimeSpan.FromSeconds(1));
        rig.Received(1);

        rig.Send(0, Frames.Of(new RadioStatus { Rssi = 1 }, 51, 68));

        Assert.Equal(expected, rig.ReceivedFrames(1).Count(f => f.MessageId == RadioStatus.MavlinkId));
    }

    [Fact]
    public void UnknownId_ByOption_IsNotForwarded()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2, o => o.ForwardsUnknownMessages = false).As(1);

        rig.Send(0, Frames.Raw(Frames.UnknownId, [1, 2, 3], crcExtra: 77));

        Assert.Empty(rig.Received(1));
    }

    [Fact]
    public void Missing_OfSeveralSenders_IsNotCounted()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 1).As(1);
        rig.Send(0, Frames.Heartbeat(sequence: 1), Frames.Heartbeat(sequence: 4), Frames.Heartbeat(sequence: 3));
        Assert.Equal(1, rig.Status(0).FramesMissing);

        // From here on a router may keep frames of either.
        rig.Send(0, Frames.Heartbeat(system: 255, component: 190), Frames.Heartbeat(sequence: 40));

        Assert.Equal(1, rig.Status(0).FramesMissing);
    }
}
