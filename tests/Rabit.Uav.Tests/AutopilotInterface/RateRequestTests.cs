using System;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

public class RateRequestTests
{
    private static readonly int[] AttitudeAndPosition = [30, 33];

    [Fact]
    public void Rates_AutopilotAnswers_AreAskedOneByOne()
    {
        using AutopilotRig rig = MakeRig();
        rig.Run(3);
        Assert.Empty(rig.Sink.Frames);
        rig.Send(AutopilotRig.Copter(), system: 3);
        rig.Run();
        (_, MavlinkFrame first) = Assert.Single(
            rig.Sink.Frames,
            f => f.Frame.TryDecode(out CommandLong c) && c.Command == MavCmd.SetMessageInterval);
        CommandLong command = OutgoingSink.Decode<CommandLong>(first);
        Assert.Equal((3, 191), (first.SystemId, first.ComponentId));
        Assert.Equal((3, 1), (command.TargetSystem, command.TargetComponent));
        Assert.Equal((MavCmd.SetMessageInterval, 30f), (command.Command, command.Param1));

        Answer(rig, MavResult.Accepted, system: 3);
        Answer(rig, MavResult.Accepted, system: 3);
        Assert.Equal(AttitudeAndPosition, Asked(rig));
        Assert.Equal((2L, 0L, 0L, 2L), Counts(rig));
    }

    [Fact]
    public void Rates_NoAnswer_AreAskedThreeTimesEach()
    {
        using AutopilotRig rig = MakeRig();
        rig.Beat(10);

        Assert.Equal([30, 30, 30, 33, 33, 33], Asked(rig));
        Assert.Equal((0L, 0L, 2L, 6L), Counts(rig));
    }

    [Theory]
    [InlineData(2, 1, 0, 0)]      // another system
    [InlineData(1, 154, 0, 0)]    // another component
    [InlineData(1, 1, 1, 190)]    // an answer for the ground station
    [InlineData(1, 1, 255, 191)]
    public void Rates_AnswerThatIsNotForUs_IsNotTaken(
        byte system, byte component, byte targetSystem, byte targetComponent)
    {
        using AutopilotRig rig = MakeRig();
        rig.Beat(1);
        int asked = Asked(rig).Length;
        rig.Send(
            new CommandAck
            {
                Command = MavCmd.SetMessageInterval,
                TargetSystem = targetSystem,
                TargetComponent = targetComponent
            },
            system, component);
        rig.Run();

        Assert.Equal(asked, Asked(rig).Length);
        Assert.Equal(0, rig.Statistics.RateRequests.Accepted);
    }

    [Fact]
    public void Rates_AnswerToAnotherCommand_IsNotTaken()
    {
        using AutopilotRig rig = MakeRig();
        rig.Beat(1);
        rig.Send(new CommandAck { Command = MavCmd.ComponentArmDisarm });
        rig.Run();
        Assert.Equal(0, rig.Statistics.RateRequests.Accepted);
    }

    [Fact]
    public void Rates_Refused_AreNotAskedAgainBeforeAReconnection()
    {
        using AutopilotRig rig = MakeRig();
        rig.Beat(1);
        Answer(rig, MavResult.Denied);
        Answer(rig, MavResult.Accepted);
        rig.Sink.Frames.Clear();
        rig.Beat(20);
        Assert.Empty(Asked(rig));
        Assert.Equal((1L, 1L), (rig.Statistics.RateRequests.Accepted, rig.Statistics.RateRequests.Refused));

        rig.Run(10);
        rig.Beat(1);
        Assert.Equal(30, Asked(rig)[0]);
    }

    [Fact]
    public void Rates_AutopilotLost_AreNotAskedMeanwhile()
    {
        using AutopilotRig rig = MakeRig();
        rig.Send(AutopilotRig.Copter());
        rig.Run(5.5);   // lost in the middle of the tries for the second message
        rig.Sink.Frames.Clear();
        rig.Run(20);
        Assert.Empty(rig.Sink.Frames);
    }

    [Fact]
    public void Rates_AutopilotReboots_AreAskedAgain()
    {
        using AutopilotRig rig = MakeRig();
        rig.Beat(1);
        Answer(rig, MavResult.Accepted);
        Answer(rig, MavResult.Accepted);
        rig.Send(new SystemTime { TimeBootMs = 100_000 });
        rig.Beat(1);
        rig.Sink.Frames.Clear();
        rig.Send(new SystemTime { TimeBootMs = 2_000 });
        rig.Send(new SystemTime { TimeBootMs = 2_100 });
        rig.Run();

        Assert.Equal(30, Assert.Single(Asked(rig)));
        Assert.Equal((1L, 0L), (rig.Statistics.Reboots, rig.Statistics.Losses));
    }

    [Fact]
    public void Rates_OfAReplay_AreNotAsked()
    {
        using var rig = new AutopilotRig(new AutopilotOptions { RequestsRates = false });
        rig.Beat(10);
        Assert.Empty(rig.Sink.Frames);
    }

    private static AutopilotRig MakeRig() => new(new AutopilotOptions { RequestedRates = [new(30, 10), new(33, 5)] });

    private static void Answer(AutopilotRig rig, MavResult result, byte system = 1)
    {
        rig.Send(
            new CommandAck
            {
                Command = MavCmd.SetMessageInterval,
                Result = result,
                TargetSystem = system,
                TargetComponent = 191
            },
            system);
        rig.Run();
    }

    private static int[] Asked(AutopilotRig rig)
        => rig.Sink.MessagesOf<CommandLong>().Where(c => c.Command == MavCmd.SetMessageInterval)
            .Select(c => (int)c.Param1).ToArray();

    private static (long Accepted, long Refused, long Unanswered, long Sent) Counts(AutopilotRig rig)
    {
        RateRequestCounts counts = rig.Statistics.RateRequests;
        return (counts.Accepted, counts.Refused, counts.Unanswered, counts.Sent);
    }
}
