using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>Who commands: we only where we may, and never against the pilot.</summary>
public class AuthorityTests
{
    public static TheoryData<VehicleCommandKind> EveryKind => new(
        typeof(VehicleCommandKind).GetEnumValues().Cast<VehicleCommandKind>()
            .Where(k => k is not (VehicleCommandKind.None or VehicleCommandKind.TakeControl)).ToArray());

    [Theory]
    [MemberData(nameof(EveryKind))]
    public void Observing_EveryCommand_IsAnsweredNotInCommandAndNothingSent(VehicleCommandKind kind)
    {
        using var copter = new ScriptedAutopilot(mayCommand: false);
        copter.Run(1.5);
        VehicleCommandResult answer = copter.GiveAndRun(kind);
        Assert.Equal(
            (VehicleCommandOutcome.NotInCommand, "observing only", kind), (answer.Outcome, answer.Text, answer.Kind));
        Assert.Empty(copter.Received);
        Assert.Equal(CommandAuthorityState.Observing, copter.Authority);
    }

    [Fact]
    public void Default_IsObserving() => Assert.False(new AutopilotOptions().MayCommand);

    [Fact]
    public void Free_PilotChangesModesBeforeOurFirstCommand_IsNoTakeover()
    {
        using var copter = new ScriptedAutopilot();
        copter.Run(1.5);
        Assert.Equal(CommandAuthorityState.Free, copter.Authority);
        copter.Mode = (uint)CopterMode.Loiter;
        copter.Run(2);
        Assert.Equal(CommandAuthorityState.Free, copter.Authority);
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.Arm).Outcome);
    }

    [Theory]
    [MemberData(nameof(EveryKind))]
    public void Takeover_InTheMiddleOfACommand_NotOneFrameMore(VehicleCommandKind kind)
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Script = (_, _) => null;   // so that it is still at it
        long id = copter.Give(kind);
        copter.Run(1);
        int received = copter.Received.Count;
        Assert.True(received > 2);

        copter.Mode = (uint)CopterMode.Loiter;
        copter.Latency = 0;
        copter.Beat();
        copter.Run(30);

        CommandAuthority authority = copter.Rig.Authority;
        Assert.Equal((CommandAuthorityState.TakenAway, "mode LOITER"), (authority.State, authority.TakenBy));
        Assert.Equal(received, copter.Received.Count);
        VehicleCommandResult answer = copter.Answers.Single(a => a.Id == id);
        if (kind is not (VehicleCommandKind.Velocity or VehicleCommandKind.SetMode))   // done by then
            Assert.Equal(
                (VehicleCommandOutcome.NotInCommand, "mode LOITER took the command away"),
                (answer.Outcome, answer.Text));

        // And it stays so, also when the pilot gives GUIDED back.
        copter.Mode = (uint)CopterMode.Guided;
        copter.Run(3);
        Assert.Equal(VehicleCommandOutcome.NotInCommand, copter.GiveAndRun(VehicleCommandKind.Return).Outcome);
        Assert.Equal(received, copter.Received.Count);
    }

    [Fact]
    public void Takeover_BetweenCommands_IsSeenToo()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Mode = (uint)CopterMode.Rtl;   // a failsafe of the autopilot
        copter.Run(1.5);
        Assert.Equal("mode RTL", copter.Rig.Authority.TakenBy);
        Assert.Equal(VehicleCommandOutcome.NotInCommand, copter.GiveAndRun(VehicleCommandKind.GoTo).Outcome);
    }

    [Fact]
    public void Mode_OneReportOfTheModeBeforeAfterTheAcknowledgement_IsNoTakeover()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Script = (frame, command) =>
        {
            copter.Accept(frame, command);
            copter.Later(0.001, () => copter.Beat((uint)CopterMode.Guided));   // sent just before the change
            return MavResult.Accepted;
        };
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.Return).Outcome);
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
    }

    [Theory]
    [InlineData(0.05)]   // it has to be confirmed, which takes one more request
    [InlineData(0.5)]
    public void Mode_PilotTakesTheModeBeforeAfterTheAcknowledgement_IsATakeover(double laterSeconds)
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Script = (frame, command) =>
        {
            copter.Accept(frame, command);
            copter.Later(laterSeconds, () => copter.Mode = (uint)CopterMode.Guided);
            return MavResult.Accepted;
        };
        copter.GiveAndRun(VehicleCommandKind.Return, seconds: laterSeconds + 0.4);
        Assert.Equal(
            (CommandAuthorityState.TakenAway, "mode GUIDED"), (copter.Authority, copter.Rig.Authority.TakenBy));
    }

    [Fact]
    public void Mode_ThirdOneWhileWeAsk_IsATakeoverAtOnce()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Script = (_, _) =>
        {
            copter.Mode = (uint)CopterMode.Poshold;
            copter.Beat();
            return MavResult.Accepted;
        };
        VehicleCommandResult answer = copter.GiveAndRun(VehicleCommandKind.Return, seconds: 0.2);
        Assert.Equal(VehicleCommandOutcome.NotInCommand, answer.Outcome);
        Assert.Equal("mode POSHOLD", copter.Rig.Authority.TakenBy);
    }

    [Fact]
    public void Mode_RtlThatBecomesLand_IsOursButLandThatBecomesRtlIsNot()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.Return).Outcome);
        copter.Mode = (uint)CopterMode.Land;
        copter.Run(5);
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
        copter.Mode = (uint)CopterMode.Rtl;
        copter.Run(5);
        Assert.Equal(CommandAuthorityState.TakenAway, copter.Authority);
    }

    [Fact]
    public void Mode_RefusedByTheAutopilot_IsNotOursWhenItComesAllTheSame()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Script = (_, _) => MavResult.Failed;
        Assert.Equal(VehicleCommandOutcome.Refused, copter.GiveAndRun(VehicleCommandKind.Land).Outcome);
        copter.Mode = (uint)CopterMode.Land;
        copter.Run(1.5);
        Assert.Equal(CommandAuthorityState.TakenAway, copter.Authority);
    }

    [Fact]
    public void Mode_OfAReplacedRequest_IsStillOurs()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Give(VehicleCommandKind.Return);
        copter.Run(0.1);
        long land = copter.Give(VehicleCommandKind.Land);
        copter.Later(0, () => copter.Beat((uint)CopterMode.Rtl));   // passed through on the way
        copter.Run(5);
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.Answers.Single(a => a.Id == land).Outcome);
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
    }

    [Fact]
    public void Loss_SameModeAfterwards_IsStillOurs()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Beats = false;
        copter.Run(10);
        Assert.False(copter.Rig.Vehicle.IsConnected);
        copter.Beats = true;
        copter.Run(2);
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.GoTo).Outcome);
    }

    [Fact]
    public void Loss_AnotherModeAfterwards_IsATakeover()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Beats = false;
        copter.Run(10);
        copter.Mode = (uint)CopterMode.Rtl;
        copter.Beats = true;
        copter.Run(2);
        Assert.Equal(CommandAuthorityState.TakenAway, copter.Authority);
    }

    [Theory]
    [InlineData(true, CommandAuthorityState.TakenAway)]
    [InlineData(false, CommandAuthorityState.Free)]
    public void Reboot_InFlightTakesTheCommandAwayOnTheGroundItDoesNot(bool isArmed, CommandAuthorityState expected)
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.IsArmed = isArmed;
        copter.Run(2);
        long id = copter.Give(VehicleCommandKind.GoTo);
        copter.Say(new SystemTime { TimeBootMs = 1_000 });
        copter.Say(new SystemTime { TimeBootMs = 1_040 });
        copter.Latency = 5;   // nothing more is received before we decide
        copter.Run(0.1);
        Assert.Equal(expected, copter.Authority);
        if (isArmed)
        {
            Assert.Equal("a reboot of the autopilot", copter.Rig.Authority.TakenBy);
            Assert.Equal(VehicleCommandOutcome.NotInCommand, copter.Answers.Single(a => a.Id == id).Outcome);
        }
    }

    [Fact]
    public void Reboot_ItsModeIsReportedBeforeItsTime_IsTheCauseOfTheTakeover()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Say(new ExtendedSysState { LandedState = MavLandedState.InAir });
        copter.Mode = (uint)CopterMode.Stabilize;
        copter.Run(2);
        Assert.Equal(TakeoverCause.Mode, copter.Rig.Authority.Cause);
        copter.Say(new SystemTime { TimeBootMs = 1_000 });
        copter.Say(new SystemTime { TimeBootMs = 1_040 });
        copter.Run(0.1);
        Assert.Equal(TakeoverCause.Reboot, copter.Rig.Authority.Cause);
        Assert.Equal("a reboot of the autopilot", copter.Rig.Authority.TakenBy);
    }

    [Fact]
    public void Landing_DisarmAfterwards_IsNoTakeover()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.GiveAndRun(VehicleCommandKind.Land);
        copter.IsArmed = false;
        copter.Say(new ExtendedSysState { LandedState = MavLandedState.OnGround });
        copter.Run(10);
        Assert.Equal(CommandAuthorityState.Free, copter.Authority);
    }

    [Fact]
    public void Heartbeats_OfAnotherAutopilot_TakeNothingAway()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Rig.Send(AutopilotRig.Copter(CopterMode.Loiter), system: 7);
        copter.Run(2);
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
    }
}
