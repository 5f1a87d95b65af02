using System;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Links;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>What Communications reports of a link.</summary>
public sealed class LinkStatusTests
{
    [Fact]
    public void State_NoFrameEver_IsWaiting()
    {
        using var rig = new CommunicationsRig(links: 1);
        rig.Put(0, [1, 2, 3]);

        rig.Run(TimeSpan.FromSeconds(60));

        LinkStatus status = rig.Status(0);
        Assert.Equal((LinkState.Waiting, 0L, 3L), (status.State, status.FramesIn, status.BytesLost));
        Assert.Null(status.LastFrameTime);
        Assert.True(double.IsNaN(status.Progress));
    }

    [Fact]
    public void State_FramesComeStopAndComeAgain_IsReceivingSilentReceiving()
    {
        using var rig = new CommunicationsRig(links: 1, o => o.SilentAfter = TimeSpan.FromSeconds(3));
        rig.Send(0, Frames.Heartbeat());
        Assert.Equal(LinkState.Receiving, rig.Status(0).State);
        rig.Run(TimeSpan.FromSeconds(2));
        Assert.Equal(LinkState.Receiving, rig.LastStatus(0).State);

        rig.Run(TimeSpan.FromSeconds(1));
        Assert.Equal(LinkState.Silent, rig.Status(0).State);

        rig.Send(0, Frames.Heartbeat(sequence: 1));
        Assert.Equal(LinkState.Receiving, rig.Status(0).State);
        Assert.Equal("memory:link0/a", rig.Status(0).Url);
    }

    [Fact]
    public void GroundStationTime_HeartbeatOfAGroundStation_IsWhenTheLastCame()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);
        rig.Send(0, Frames.Heartbeat());
        rig.Send(1, Frames.Of(new Heartbeat { Type = MavType.OnboardController }, 2, 191));
        rig.Run(TimeSpan.FromSeconds(1));
        Assert.Null(rig.Status(0).GroundStationTime);

        rig.Send(1, Frames.Of(new Heartbeat { Type = MavType.Gcs }, 255, 190));
        Assert.Null(rig.Status(0).GroundStationTime);
        TimeSpan? received = rig.Status(1).LastFrameTime;
        Assert.Equal(received, rig.Status(1).GroundStationTime);
        rig.Run(TimeSpan.FromSeconds(5));
        rig.Send(1, Frames.Heartbeat(2));
        Assert.Equal(received, rig.Status(1).GroundStationTime);
    }

    [Fact]
    public void State_FarEndCloses_IsEndedAndStaysSo()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 2).As(1);
        rig.Send(0, Frames.Heartbeat());

        rig.Far(0).Dispose();
        Assert.Equal(LinkState.Ended, rig.Status(0).State);

        rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });
        rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });
        LinkStatus status = rig.Status(0);
        Assert.Equal((LinkState.Ended, null), (status.State, status.Fault));
        Assert.Equal((0L, 2L), (status.FramesOut, status.FramesDroppedOut));
        Assert.Equal(3, rig.Status(1).FramesOut);
    }

    [Fact]
    public void State_ReadThrows_IsFailedAndNamedAndTheOthersGoOn()
    {
        var faulty = new FaultyLink();
        using CommunicationsRig rig = new CommunicationsRig(links: 1, o => o.Links = [.. o.Links, faulty]).As(1);
        faulty.Give(Frames.Heartbeat());
        rig.Run();

        faulty.FailReading(new LinkException("fake:0", "the cable is out", linkEnded: true));
        LinkStatus status = rig.Status(1);

        Assert.Equal(
            (LinkState.Failed, "link fake:0: the cable is out", 1L), (status.State, status.Fault, status.FramesIn));
        Assert.Contains(rig.Log, e => e.Kind == RabitLogKind.Fault && e.Source == "communications/link 1 in"
            && e.Text.Contains("the cable is out"));
        rig.Send(0, Frames.Heartbeat(sequence: 5));
        Assert.Equal(5, rig.Autopilot.Taken.Last().Frame.Sequence);
        ReactorResult result = rig.Finish();
        Assert.Equal(0, result.ExitCode);
    }

    [Fact]
    public void State_WriteThrows_IsFailedAndNamedAndTheOthersGoOn()
    {
        var faulty = new FaultyLink { WriteFault = new InvalidOperationException("broken") };
        using CommunicationsRig rig = new CommunicationsRig(links: 1, o => o.Links = [.. o.Links, faulty]).As(1);

        rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });
        rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });

        LinkStatus status = rig.Status(1);
        Assert.Equal((LinkState.Failed, "broken"), (status.State, status.Fault));
        Assert.Equal((0L, 2L), (status.FramesOut, status.FramesDroppedOut));
        Assert.Equal(2, rig.ReceivedFrames(0).Count);
    }

    [Fact]
    public void State_OneWriteFails_CountsTheFrameAndGoesOn()
    {
        var faulty = new FaultyLink { WriteFault = new LinkException("fake:0", "no room", linkEnded: false) };
        using CommunicationsRig rig = new CommunicationsRig(links: 0, o => o.Links = [faulty]).As(1);
        rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });
        faulty.WriteFault = null;
        rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });

        LinkStatus status = rig.Status(0);
        Assert.Equal(1, faulty.Written);
        Assert.Equal((LinkState.Waiting, 1L, 1L), (status.State, status.FramesOut, status.FramesDroppedOut));
    }

    [Fact]
    public void AllLiveLinksEnded_RunGoesOn()
    {
        using CommunicationsRig rig = new CommunicationsRig(links: 1).As(1);
        rig.Far(0).Dispose();

        Assert.True(rig.Reactor.RunFor(TimeSpan.FromSeconds(10)));
    }
}
