using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Recorded logs: nothing of them is lost, and nothing of them gets out.</summary>
public sealed class RecordedLogTests
{
    [Fact]
    public void RecordedFrames_AreNeverForwardedToALiveLink()
    {
        using TestLog log = new TestLog()
            .Record(0, Frames.Heartbeat())
            .Record(1000, Frames.Raw(Frames.UnknownId, [1, 2]))
            .Record(2000, Frames.Of(Frames.Command(7, 1), 255, 190))
            .Record(3000, Frames.Heartbeat(sequence: 1));
        using var rig = new CommunicationsRig(links: 2, o => o.RecordedFiles = [log.Open()]);
        rig.Send(0, Frames.Heartbeat(system: 7));
        rig.Received(1);

        LinkStatus status = rig.Status(2);

        Assert.Equal((LinkState.Ended, 4L), (status.State, status.FramesIn));
        Assert.Empty(rig.Received(0));
        Assert.Empty(rig.Received(1));
    }

    [Fact]
    public void OwnAndForeignFrames_NeverGoToARecordedLog()
    {
        using TestLog log = new TestLog().Record(0, Frames.Heartbeat()).Record(1, Frames.Heartbeat(component: 191));
        using CommunicationsRig rig = new CommunicationsRig(links: 1, o => o.RecordedFiles = [log.Open()]).As(1);
        rig.SendOwn(new Heartbeat { MavlinkVersion = 3 });
        rig.SendOwn(Frames.Command(1, 1));
        rig.Send(0, Frames.Of(Frames.Command(1, 1), 255, 190));

        Assert.Equal((0L, 0L), (rig.Status(1).FramesOut, rig.Status(1).FramesDroppedOut));
        Assert.Equal(Heartbeat.MavlinkId, Assert.Single(rig.ReceivedFrames(0)).MessageId);
    }

    [Fact]
    public void FramesOfTheRecorder_BeforeTheVehicleIsKnown_AreNotHandedOverEither()
    {
        using TestLog log = new TestLog().Record(0, Frames.Heartbeat(component: 191)).Record(1, Frames.Heartbeat());
        using var rig = new CommunicationsRig(links: 0, o => o.RecordedFiles = [log.Open()]);
        rig.Run(TimeSpan.FromSeconds(1));

        Assert.Equal(1, Assert.Single(rig.Autopilot.Taken).Frame.ComponentId);
        Assert.Equal(2, rig.Manager.SummariseLinks()[0].Frames);
    }

    [Fact]
    public void AnswersToAGroundStation_InALog_ArePartOfTheFlight()
    {
        var answer = new CommandAck { Command = MavCmd.NavTakeoff, TargetSystem = 255, TargetComponent = 190 };
        using TestLog log = new TestLog().Record(0, Frames.Heartbeat()).Record(1, Frames.Of(answer));
        using CommunicationsRig rig = new CommunicationsRig(links: 1, o => o.RecordedFiles = [log.Open()]).As(1);
        rig.Run(TimeSpan.FromSeconds(1));
        Assert.Equal([Heartbeat.MavlinkId, CommandAck.MavlinkId], rig.Autopilot.Taken.Select(f => f.Frame.MessageId));

        // On a live link they are another system's.
        rig.Send(0, Frames.Of(answer, sequence: 1));
        rig.Run(TimeSpan.FromSeconds(1));
        Assert.Equal(2, rig.Autopilot.Taken.Count);
    }

    [Fact]
    public void StatusAfterAStop_OfALogThatWasNotAtItsEnd_IsNotEnded()
    {
        using TestLog log = new TestLog().Record(0, Frames.Heartbeat())
            .Record(9_000_000, Frames.Heartbeat(sequence: 1));
        using var rig = new CommunicationsRig(links: 0, o => o.RecordedFiles = [log.Open()]);
        rig.Run(TimeSpan.FromSeconds(1));
        rig.Reactor.Stop();
        rig.Finish();

        Assert.Equal(LinkState.Receiving, rig.LastStatus(0).State);
    }

    [Fact]
    public void FramesOfTheRecorder_AreCountedButNotHandedOver()
    {
        using TestLog log = new TestLog().Record(500_000, Frames.Heartbeat())
            .Record(500_001, Frames.Heartbeat(component: 191));
        using CommunicationsRig rig = new CommunicationsRig(links: 0, o => o.RecordedFiles = [log.Open()]).As(1);
        rig.Run(TimeSpan.FromSeconds(1));

        Assert.Equal(1, Assert.Single(rig.Autopilot.Taken).Frame.ComponentId);
        Assert.Equal(2, rig.Manager.SummariseLinks()[0].Frames);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void OneStampForAllRecords_AutopilotSlow_LosesNothing(long seed)
    {
        const int count = 5000;
        using var log = new TestLog();
        log.Raw(SameStamp(count));
        var autopilot = new FakeAutopilot(capacity: 16) { AtMost = 10 };
        using var rig = new CommunicationsRig(0, o => Replay(o, log), autopilot, seed);

        ReactorResult result = rig.FinishByItself();

        Assert.Null(result.Failure);
        Assert.Equal("communications: the recorded flight is over", result.StopReason);
        Assert.Equal(Enumerable.Range(0, count).Select(n => (long)n), autopilot.Taken.Select(f => f.Index));
        Assert.Equal(0, rig.LastStatus(0).FramesDroppedIn);
        Assert.Equal(count, rig.Manager.SummariseLinks()[0].Frames);
    }

    [Fact]
    public void AutopilotFull_ReplayIsWokenByItsPops_NotByPolling()
    {
        using var log = new TestLog();
        log.Raw(SameStamp(200));
        var autopilot = new FakeAutopilot(capacity: 16) { AtMost = 1 };
        using var rig = new CommunicationsRig(0, o => Replay(o, log), autopilot);

        ReactorResult result = rig.FinishByItself();
        long runs = result.Managers.Single(m => m.Name == CommunicationsManager.ManagerName).Runs;

        // One frame every 10 ms; polling each millisecond would take 2000 units of work.
        Assert.Equal(200, autopilot.Taken.Count);
        Assert.InRange(runs, 1, 500);
    }

    [Fact]
    public void StopInTheMiddle_DropsNothingForLackOfRoom()
    {
        using var log = new TestLog();
        log.Raw(SameStamp(5000));
        FakeAutopilot? autopilot = null;
        autopilot = new FakeAutopilot(capacity: 16, f => StopAt(autopilot!, f, index: 1000)) { AtMost = 10 };
        using var rig = new CommunicationsRig(0, o => Replay(o, log), autopilot);

        ReactorResult result = rig.FinishByItself();

        Assert.Equal(0, result.ExitCode);
        Assert.Equal("autopilot: enough", result.StopReason);
        Assert.Equal(0, rig.LastStatus(0).FramesDroppedIn);
    }

    [Fact]
    public void TwoLogs_MergeByTheirStamps()
    {
        using var even = new TestLog("even.tlog");
        using var odd = new TestLog("odd.tlog");
        for (int n = 0; n < 400; n++)
            (n % 2 == 0 ? even : odd)
                .Record(n * 2500, Frames.Heartbeat(system: (byte)(1 + (n % 2)), sequence: (byte)(n / 2)));
        using var rig = new CommunicationsRig(0, o => o.RecordedFiles = [odd.Open(), even.Open()]);

        rig.Run(TimeSpan.FromSeconds(2));

        Assert.Equal(
            Enumerable.Range(0, 400).Select(n => TestLog.Start + (n * 2500L)),
            rig.Autopilot.Taken.Select(f => f.UtcMicroseconds));
        Assert.Equal(Enumerable.Range(0, 400).Select(n => 1 - (n % 2)), rig.Autopilot.Taken.Select(f => f.Link));
        Assert.All(rig.Autopilot.Taken, f => Assert.Equal((f.UtcMicroseconds - TestLog.Start) * 10, f.Time.Ticks));
    }

    [Fact]
    public void EndOfAllLogs_StopsOnlyAfterEverythingWasHandled()
    {
        using TestLog brief = new TestLog("brief.tlog").Record(0, Frames.Heartbeat());
        using var lengthy = new TestLog("long.tlog");
        lengthy.Raw(SameStamp(2000)).Record(3_000_000, Frames.Heartbeat(sequence: 200));
        var autopilot = new FakeAutopilot(capacity: 8) { AtMost = 1 };
        using var rig = new CommunicationsRig(0, o => Replay(o, brief, lengthy), autopilot);

        ReactorResult result = rig.FinishByItself();

        Assert.Equal("communications: all links have ended", result.StopReason);
        Assert.Equal(2002, autopilot.Taken.Count);
        Assert.Equal((LinkState.Ended, 1.0), (rig.LastStatus(1).State, rig.LastStatus(1).Progress));
    }

    [Fact]
    public void ClockStepsBack_LongFlightAfterIt_IsPlayedToItsEnd()
        => PlayAfterAStepBack(count: 90_000, microseconds: 60_000);

    [Fact, Trait("Category", "Long")]
    public void ClockStepsBack_LongFlightOfManyRecordsAfterIt_IsPlayedToItsEnd()
        => PlayAfterAStepBack(count: 900_000, microseconds: 6000);

    [Fact]
    public void ClockStepsForward_ByYears_IsPlayedOnAtOnce()
    {
        using TestLog log = new TestLog().Record(0, Frames.Heartbeat());
        log.Record(10L * 365 * 24 * 3_600_000_000, Frames.Heartbeat(sequence: 1))
            .Record((10L * 365 * 24 * 3_600_000_000) + 2_000_000, Frames.Heartbeat(sequence: 2));
        var autopilot = new FakeAutopilot(1024);
        using var rig = new CommunicationsRig(0, o => Replay(o, log), autopilot);

        ReactorResult result = rig.FinishByItself();

        Assert.Null(result.Failure);
        Assert.Equal([0, 0, 2], autopilot.Taken.Select(f => f.Time.TotalSeconds));
    }

    private static void PlayAfterAStepBack(int count, long microseconds)
    {
        using var log = new TestLog();
        log.Record(7_000_000_000, Frames.Heartbeat());
        var bytes = new List<byte>();
        for (int n = 1; n < count; n++)
            bytes.AddRange(Stamped(n * microseconds, Frames.Heartbeat(sequence: (byte)n)));
        log.Raw(bytes.ToArray());
        var autopilot = new FakeAutopilot(1024) { Keeps = false };
        using var rig = new CommunicationsRig(0, o => Replay(o, log), autopilot);

        ReactorResult result = rig.FinishByItself();

        Assert.Null(result.Failure);
        Assert.Equal(count, rig.Manager.SummariseLinks()[0].Frames);
    }

    private static void StopAt(FakeAutopilot autopilot, in LinkFrame frame, long index)
    {
        if (frame.Index == index)
            autopilot.Stop("enough");
    }

    private static void Replay(Rabit.Uav.Communications.CommunicationsOptions options, params TestLog[] logs)
    {
        options.RecordedFiles = logs.Select(l => l.Open()).ToList();
        options.StopsWhenAllLinksEnd = true;
    }

    private static byte[] SameStamp(int count)
        => Enumerable.Range(0, count).SelectMany(n => Stamped(0, Frames.Heartbeat(sequence: (byte)n))).ToArray();

    private static byte[] Stamped(long microseconds, byte[] frame)
    {
        long stamp = TestLog.Start + microseconds;
        return Enumerable.Range(0, 8).Select(i => (byte)(stamp >> (56 - (8 * i)))).Concat(frame).ToArray();
    }
}
