using System;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>The operator's commands: hold, return, continue; and control, which only he gives back.</summary>
public class OperatorCommandTests
{
    public static readonly TheoryData<MissionPhase> AllFlown
        = [MissionPhase.TakingOff, MissionPhase.InTransit, MissionPhase.Searching, MissionPhase.Revisiting,
            MissionPhase.Returning];

    [Theory]
    [MemberData(nameof(AllFlown))]
    public void Hold_InTheAir_HoldsUntilTheMissionIsResumedAndFinishesIt(MissionPhase phase)
    {
        using MissionRig rig = MissionRig.In(phase);
        rig.Run(2);
        rig.Manager.Hold("test", "a walker");
        rig.Run(4);
        (double north, double east, double height) = (rig.Vehicle.North, rig.Vehicle.East, rig.Vehicle.Height);
        rig.Run(60);

        Assert.Equal((MissionPhase.Holding, "holding: a walker"), (rig.Status.Phase, rig.Status.Text));
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Hold));
        Assert.Equal(
            (north, east, height), (rig.Vehicle.North, rig.Vehicle.East, rig.Vehicle.Height));

        rig.Manager.ContinueMission("test", "clear");
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(MissionOutcome.Accomplished, rig.Status.Result.Outcome);
        Assert.InRange(rig.Status.Coverage, 0.985, 1);
        Assert.DoesNotContain(rig.Vehicle.Commands, c => c.Command.Kind == VehicleCommandKind.TakeControl);
    }

    [Fact]
    public void Resume_InALane_ContinuesWhereItWasLeft()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        while (rig.Status.LanesFlown < 1)
            rig.Run(0.5);
        rig.Run(12);
        rig.Manager.Hold("test", "test");
        rig.Run(5);
        int held = rig.Vehicle.Path.Count;
        double east = rig.Vehicle.East;
        int lanes = rig.Status.LanesFlown;
        rig.Manager.ContinueMission("test", "test");
        while (rig.Status.LanesFlown == lanes)
            rig.Run(0.5);

        // It goes back by the overlap only, and not to the beginning of the lane.
        Assert.All(rig.Vehicle.Path.Skip(held), p => Assert.InRange(Math.Abs(p.East), 0, Math.Max(62, Math.Abs(east))));
        double back = rig.Vehicle.Path.Skip(held).Max(p => Math.Abs(p.East - east) * Math.Sign(p.East - east)
            * -Math.Sign(rig.Vehicle.East - east));
        // The overlap, 24 m, and the way in which it braked.
        Assert.InRange(back, 20, 45);
    }

    [Theory]
    [MemberData(nameof(MissionPhases.InTheAir), MemberType = typeof(MissionPhases))]
    public void TakenOver_ModeIsOursAgain_NothingIsCommandedWithoutTheOperator(MissionPhase phase)
    {
        using MissionRig rig = MissionRig.In(phase);
        rig.Vehicle.TakeOver("mode LOITER");
        rig.Run(2);
        int commands = rig.Vehicle.Commands.Count;
        rig.Vehicle.Authority = new CommandAuthority { State = CommandAuthorityState.Ours };
        rig.Run(60);

        Assert.Equal(MissionPhase.HandedOver, rig.Status.Phase);
        Assert.Equal(commands, rig.Vehicle.Commands.Count);
    }

    [Theory]
    [MemberData(nameof(AllFlown))]
    public void Resume_AfterATakeover_TakesControlAndFinishesTheMission(MissionPhase phase)
    {
        using MissionRig rig = MissionRig.In(phase);
        rig.Vehicle.TakeOver("mode LOITER");
        rig.Run(20);
        int before = rig.Vehicle.Commands.Count;
        double seen = rig.Status.Coverage;
        rig.Manager.ContinueMission("test", "the pilot gives it back");
        rig.Run(3);

        Assert.Equal(VehicleCommandKind.TakeControl, rig.Vehicle.Commands[before].Command.Kind);
        Assert.InRange(rig.Status.Coverage, seen, 1);
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        MissionStatus end = rig.Status;
        Assert.Equal((MissionOutcome.Accomplished, MissionFailures.None), (end.Result.Outcome, end.Result.Failures));
        Assert.Equal("the pilot took over: mode LOITER", end.TakenOver);
        Assert.InRange(end.Coverage, 0.985, 1);
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.TakeControl));
    }

    [Fact]
    public void Return_AfterATakeover_ReturnsAndTheMissionIsTakenOverAllTheSame()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.TakeOver("mode LOITER");
        rig.Run(5);
        rig.Manager.ReturnToLaunch("test", "enough");
        rig.Run(2);
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(
            MissionFailures.GivenUp | MissionFailures.TakenOver | MissionFailures.AreaNotSeen,
            rig.Status.Result.Failures);
        Assert.Equal("enough", rig.Status.Aborted);
    }

    [Fact]
    public void Hold_AfterTheAutopilotsFailsafe_IsCommandedAtTheOperatorsWordOnly()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.SystemStatus = Rabit.Mavlink.Messages.MavState.Critical;
        rig.Vehicle.TakeOver("mode RTL", TakeoverCause.Failsafe);
        rig.Run(1);
        int commands = rig.Vehicle.Commands.Count;
        rig.Run(30);
        Assert.Equal(commands, rig.Vehicle.Commands.Count);
        Assert.Equal("the autopilot's failsafe took over: mode RTL", rig.Status.Text);
        rig.Manager.ContinueMission("test", "against the failsafe");
        rig.Run(2);
        Assert.Equal(commands, rig.Vehicle.Commands.Count);
        Assert.Contains("continue refused: the autopilot reports a critical state", rig.Story,
            StringComparison.Ordinal);
        rig.Manager.Hold("test", "look first");
        rig.Run(2);
        Assert.Equal(MissionPhase.Holding, rig.Status.Phase);
    }

    // The hold ends PX4's failsafe; where the state stays critical, it is not that of the failsafe.
    [Theory]
    [InlineData(true, MissionPhase.Holding)]
    [InlineData(false, MissionPhase.Returning)]
    public void Hold_InTheAutopilotsFailsafe_HoldsWhereItEndsAndReturnsWhereItDoesNot(bool ends, MissionPhase expected)
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.SystemStatus = Rabit.Mavlink.Messages.MavState.Critical;
        rig.Vehicle.TakeOver("mode AUTO.RTL", TakeoverCause.Failsafe);
        rig.Run(5);
        rig.Manager.Hold("test", "look first");
        rig.Run(2);
        Assert.Equal(MissionPhase.Holding, rig.Status.Phase);
        if (ends)
            rig.Vehicle.SystemStatus = Rabit.Mavlink.Messages.MavState.Active;
        rig.Run(8);
        Assert.Equal(expected, rig.Status.Phase);
    }

    [Fact]
    public void TakeControl_IsRefused_StaysHandedOverAndSendsNothingMore()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.TakeOver("mode LOITER");
        rig.Run(2);
        rig.Vehicle.Refuses = c => c.Kind == VehicleCommandKind.TakeControl ? VehicleCommandOutcome.Refused : null;
        rig.Manager.ContinueMission("test", "test");
        rig.Run(30);
        Assert.Equal(MissionPhase.HandedOver, rig.Status.Phase);
        Assert.Equal(3, rig.Vehicle.Count(VehicleCommandKind.TakeControl));
        Assert.Contains("the command of the vehicle was not taken", rig.Story, StringComparison.Ordinal);
    }

    [Fact]
    public void Command_AfterTheLanding_IsRefused()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.TakeOver("mode LAND");
        (rig.Vehicle.Height, rig.Vehicle.IsArmed) = (0, false);
        rig.Run(2);
        int commands = rig.Vehicle.Commands.Count;
        rig.Manager.ContinueMission("test", "test");
        rig.Vehicle.IsArmed = true;
        rig.Run(5);
        Assert.Equal(commands, rig.Vehicle.Commands.Count);
        Assert.Contains("operator test's continue refused: the mission is over", rig.Story, StringComparison.Ordinal);
    }

    [Fact]
    public void Hold_AgainstAReasonToReturn_IsRefused()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.Health = new HealthReport { Text = "battery low (20 %)", Advice = HealthAdvice.ReturnToLaunch };
        rig.RunUntil(MissionPhase.Returning, 5);
        rig.Manager.Hold("test", "test");
        rig.Run(3);
        Assert.Equal(MissionPhase.Returning, rig.Status.Phase);
        Assert.Contains("hold refused: health: battery low (20 %)", rig.Story, StringComparison.Ordinal);
    }

    [Fact]
    public void Hold_BatteryGetsLow_ReturnsAllTheSame()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Manager.Hold("test", "test");
        rig.Run(30);
        rig.Vehicle.Health = new HealthReport { Text = "battery low (20 %)", Advice = HealthAdvice.ReturnToLaunch };
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
    }

    [Fact]
    public void Resume_DuringALinkLoss_IsDroppedAfterTenSeconds()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Manager.Hold("test", "test");
        rig.Run(5);
        rig.Vehicle.IsConnected = false;
        rig.Run(6);
        rig.Manager.ContinueMission("test", "test");
        rig.Run(15);
        rig.Vehicle.IsConnected = true;
        rig.Run(5);
        Assert.Equal(MissionPhase.Holding, rig.Status.Phase);
        Assert.Contains("continue refused: not possible within 10.0 s", rig.Story, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(OperatorCommand.Hold, MissionPhase.Holding)]
    [InlineData(OperatorCommand.Return, MissionPhase.Returning)]
    public void Command_VehicleWasFlyingAtTheStart_TakesControlAndDoesIt(OperatorCommand command, MissionPhase phase)
    {
        using var rig = new MissionRig(MissionRig.Mission());
        (rig.Vehicle.IsArmed, rig.Vehicle.Height, rig.Vehicle.North) = (true, 30, 80);
        rig.Run(5);
        Assert.Equal(MissionPhase.HandedOver, rig.Status.Phase);
        rig.Manager.Give(new OperatorRequest(command, "test", "after a restart"));
        rig.Run(2);
        Assert.Equal(phase, rig.Status.Phase);
        Assert.Equal(VehicleCommandKind.TakeControl, rig.Vehicle.Commands[0].Command.Kind);
        rig.Manager.ReturnToLaunch("test", "home");
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.NotEqual(MissionOutcome.Accomplished, rig.Status.Result.Outcome);
        Assert.Equal(
            "landed after the operator's command; home is the autopilot's, the distance from it not known here",
            rig.Status.Text);
        Assert.Equal(
            MissionFailures.None,
            rig.Status.Result.Failures & (MissionFailures.AreaNotSeen | MissionFailures.NotLanded));
    }

    [Fact]
    public void Resume_VehicleWasFlyingAtTheStart_IsRefused()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        (rig.Vehicle.IsArmed, rig.Vehicle.Height) = (true, 30);
        rig.Run(5);
        rig.Manager.ContinueMission("test", "test");
        rig.Run(5);
        Assert.Empty(rig.Vehicle.Commands);
        Assert.Contains("operator test's continue refused", rig.Story, StringComparison.Ordinal);
    }

    [Fact]
    public void Command_NoReasonOrNoCommand_IsRefusedByName()
    {
        using var rig = new MissionRig(null);
        Assert.Throws<ArgumentException>(() => rig.Manager.Hold("test", " "));
        Assert.Contains(
            "99", Assert.Throws<ArgumentException>(() => new OperatorRequest((OperatorCommand)99, "x", "x")).Message,
            StringComparison.Ordinal);
        rig.Manager.Hold("test", "no mission");
        rig.Run(1);
        Assert.Equal(MissionPhase.NoMission, rig.Status.Phase);
    }
}
