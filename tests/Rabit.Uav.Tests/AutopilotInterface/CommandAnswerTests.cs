using System;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>What the autopilot says to a command, how often and when, and what is made of it.</summary>
public class CommandAnswerTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Acknowledgements_SomeLost_AreAskedForAgainWithTheConfirmationCounter(int lost)
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        int tries = 0;
        copter.Script = (frame, command) => tries++ < lost ? null : copter.Accept(frame, command);
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.TakeOff).Outcome);
        Assert.Equal(
            Enumerable.Range(0, lost + 1),
            copter.Received.Skip(2).Select(f => (int)OutgoingSink.Decode<CommandLong>(f.Frame).Confirmation));
        double[] times = copter.Received.Skip(2).Select(f => f.Time.TotalSeconds).ToArray();
        for (int i = 1; i < times.Length; i++)
            Assert.InRange(times[i] - times[i - 1], 0.69, 0.8);
    }

    [Fact]
    public void Acknowledgements_AllLost_TimeOutAfterFourTries()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Script = (_, _) => null;
        VehicleCommandResult answer = copter.GiveAndRun(VehicleCommandKind.TakeOff, seconds: 20);
        Assert.Equal(
            (VehicleCommandOutcome.TimedOut, "no answer to NAV_TAKEOFF, sent 4 times"), (answer.Outcome, answer.Text));
        Assert.Equal(4, copter.Received.Count - 2);
    }

    [Theory]
    [InlineData(2, 191)]    // for another system
    [InlineData(1, 190)]    // for a ground station beside us
    public void Acknowledgements_ForOthers_AreNotOurs(byte system, byte component)
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Script = (_, command) =>
        {
            copter.Acknowledge(command, MavResult.Accepted, 0, system, component);
            return null;
        };
        Assert.Equal(VehicleCommandOutcome.TimedOut, copter.GiveAndRun(VehicleCommandKind.TakeOff).Outcome);
    }

    [Fact]
    public void Acknowledgements_BroadcastOrOfAnotherCommandOrComponent_CountByTheirKind()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Script = (_, command) =>
        {
            copter.Acknowledge(MavCmd.ComponentArmDisarm, MavResult.Denied);
            copter.Say(new CommandAck { Command = command, Result = MavResult.Denied }, component: 154);
            copter.Acknowledge(command, MavResult.Accepted, later: 0.1, system: 0, component: 0);
            return null;
        };
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.TakeOff).Outcome);
    }

    [Theory]
    [InlineData(MavResult.Denied)]
    [InlineData(MavResult.Failed)]
    [InlineData(MavResult.Unsupported)]
    [InlineData(MavResult.Cancelled)]
    public void Refusal_TextBeforeOrAfter_IsTheReason(MavResult result)
    {
        foreach (double later in new[] { -0.01, 0.1, 0.25 })
        {
            using ScriptedAutopilot copter = new ScriptedAutopilot();
            copter.Run(1.5);
            copter.SayText("PreArm: of long ago");
            copter.Run(1);
            copter.Script = (frame, command) =>
            {
                if (command != MavCmd.ComponentArmDisarm)
                    return copter.Accept(frame, command);
                copter.Later(Math.Max(0, later), () => copter.SayText("Arm: Compass not calibrated"));
                copter.Later(Math.Max(0, later), () => copter.SayText("just so that you know", MavSeverity.Info));
                copter.Acknowledge(command, result, later: 0.01);
                return null;
            };
            VehicleCommandResult answer = copter.GiveAndRun(VehicleCommandKind.Arm);
            Assert.Equal(
                (VehicleCommandOutcome.Refused,
                    $"COMPONENT_ARM_DISARM: {MavlinkNames.Of(result)} (Arm: Compass not calibrated)"),
                (answer.Outcome, answer.Text));
            Assert.Equal(2, copter.Received.Count);
        }
    }

    [Fact]
    public void InProgress_ProlongsTheWait()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Script = (_, command) =>
        {
            copter.Acknowledge(command, MavResult.Accepted, later: 8);
            copter.Acknowledge(command, MavResult.InProgress, later: 4);
            return MavResult.InProgress;
        };
        long id = copter.Give(VehicleCommandKind.TakeOff);
        copter.Run(7.9);
        Assert.DoesNotContain(copter.Answers, a => a.Id == id);
        Assert.Equal(1, copter.Received.Count - 2);
        copter.Run(1);
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.Answers.Single(a => a.Id == id).Outcome);
    }

    [Fact]
    public void InProgress_NeverEnding_IsAskedAgainAndTimesOut()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        int tries = 0;
        copter.Script = (_, _) => tries++ == 0 ? MavResult.InProgress : null;
        Assert.Equal(
            VehicleCommandOutcome.TimedOut, copter.GiveAndRun(VehicleCommandKind.TakeOff, seconds: 20).Outcome);
        Assert.Equal(4, tries);
    }

    [Theory]
    [InlineData(5, VehicleCommandOutcome.Accepted)]
    [InlineData(6, VehicleCommandOutcome.Refused)]
    public void TemporarilyRejected_IsTriedAgainAfterAPauseUpToALimit(int rejections, VehicleCommandOutcome expected)
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        int tries = 0;
        copter.Script = (frame, command) => tries++ < rejections
            ? MavResult.TemporarilyRejected
            : copter.Accept(frame, command);
        VehicleCommandResult answer = copter.GiveAndRun(VehicleCommandKind.TakeOff, seconds: 20);
        Assert.Equal(expected, answer.Outcome);
        Assert.Equal(6, tries);
        double[] times = copter.Received.Skip(2).Select(f => f.Time.TotalSeconds).ToArray();
        Assert.All(times.Zip(times.Skip(1), (a, b) => b - a), pause => Assert.InRange(pause, 0.99, 1.2));
    }

    [Fact]
    public void TakeOff_FirstAnswerLostAndRepetitionRefusedInTheAir_IsAccepted()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        int tries = 0;
        copter.Script = (_, _) =>
        {
            if (tries++ > 0)
                return MavResult.Failed;
            copter.Say(new ExtendedSysState { LandedState = MavLandedState.Takeoff });
            return null;
        };
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.TakeOff).Outcome);
    }

    [Fact]
    public void Mode_AcceptedButNeverShown_IsATakeover()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Script = (_, _) => MavResult.Accepted;
        VehicleCommandResult answer = copter.GiveAndRun(VehicleCommandKind.Return, seconds: 6);
        Assert.Equal(VehicleCommandOutcome.NotInCommand, answer.Outcome);
        Assert.Equal(
            (CommandAuthorityState.TakenAway, "mode GUIDED"), (copter.Authority, copter.Rig.Authority.TakenBy));
    }

    [Fact]
    public void Mode_ShownBeforeTheAcknowledgement_Counts()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Script = (frame, command) =>
        {
            copter.Accept(frame, command);
            copter.Beat();
            copter.Acknowledge(command, MavResult.Accepted, later: 0.4);
            return null;
        };
        Assert.Equal(
            VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.Return, seconds: 0.7).Outcome);
    }

    [Fact]
    public void Mode_ShownButNeverAcknowledged_IsAcceptedAndNotSentAgain()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Script = (frame, command) =>
        {
            copter.Accept(frame, command);
            return null;
        };
        int before = copter.Received.Count;
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.Return, seconds: 10).Outcome);
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);   // it is the mode that we asked for
        Assert.Equal(before + 1, copter.Received.Count);
    }

    [Fact]
    public void Mode_HeartbeatsLate_AreWaitedFor()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Script = (frame, command) =>
        {
            copter.Beats = false;
            copter.Later(2.5, () => copter.Beats = true);
            return copter.Accept(frame, command);
        };
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.Return, seconds: 6).Outcome);
    }
}
