using System;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Commands that are refused, time out or have no effect: each ends in something safe.</summary>
public class MissionCommandFaultTests
{
    [Fact]
    public void Arming_RefusedAtFirst_IsTriedEveryThreeSeconds()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.Refuses = c => c.Kind == VehicleCommandKind.Arm && rig.Now < TimeSpan.FromSeconds(20)
            ? VehicleCommandOutcome.Refused
            : null;
        rig.Run(10);
        Assert.Equal("arming; refused: because the test says so", rig.Status.Text);
        Assert.Equal(MissionPhase.TakingOff, rig.RunUntil(MissionPhase.TakingOff, 30));
        Assert.InRange(rig.Vehicle.Count(VehicleCommandKind.Arm), 6, 8);
    }

    [Theory]
    [InlineData(VehicleCommandOutcome.Refused)]
    [InlineData(VehicleCommandOutcome.TimedOut)]
    public void Arming_NeverPossible_IsGivenUp(VehicleCommandOutcome outcome)
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.Refuses = c => c.Kind == VehicleCommandKind.Arm ? outcome : null;
        Assert.Equal(MissionPhase.Failed, rig.RunToEnd(100));
        Assert.StartsWith("not armed within 60.0 s", rig.Status.Text!, StringComparison.Ordinal);
    }

    [Fact]
    public void TakeOff_Refused_IsGivenUpOnTheGroundAndDisarmed()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.Refuses = c => c.Kind == VehicleCommandKind.TakeOff ? VehicleCommandOutcome.Refused : null;
        Assert.Equal(MissionPhase.Failed, rig.RunToEnd(60));
        rig.Run(1);
        Assert.Equal(3, rig.Vehicle.Count(VehicleCommandKind.TakeOff));
        Assert.False(rig.Vehicle.IsArmed);
    }

    [Fact]
    public void TakeOff_DoesNotClimb_ReturnsToLaunch()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.TakingOff);
        rig.Run(5);
        rig.Vehicle.CanClimb = false;
        Assert.Equal(MissionPhase.Returning, rig.RunUntil(MissionPhase.Returning, 120));
        rig.Vehicle.CanClimb = true;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
    }

    [Fact]
    public void TakeOff_AutopilotDisarmsBeforeIt_IsArmedAgain()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.Refuses = c => c.Kind == VehicleCommandKind.TakeOff
            && rig.Vehicle.Count(VehicleCommandKind.Arm) == 1
            ? VehicleCommandOutcome.TimedOut
            : null;
        rig.RunUntil(MissionPhase.TakingOff);
        rig.Vehicle.IsArmed = false;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(2, rig.Vehicle.Count(VehicleCommandKind.Arm));
    }

    [Theory]
    [InlineData(VehicleCommandOutcome.Refused)]
    [InlineData(VehicleCommandOutcome.TimedOut)]
    public void GoTo_NeverTaken_ReturnsToLaunch(VehicleCommandOutcome outcome)
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.Refuses = c => c.Kind == VehicleCommandKind.GoTo && rig.Vehicle.Count(VehicleCommandKind.GoTo) > 5
            ? outcome
            : null;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.NotNull(rig.Status.Aborted);
        Assert.Equal(5 + 3, rig.Vehicle.Count(VehicleCommandKind.GoTo));
    }

    [Fact]
    public void Return_NeverTaken_LandsWhereItIs()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.Refuses = c => c.Kind == VehicleCommandKind.Return ? VehicleCommandOutcome.Refused : null;
        rig.Manager.ReturnToLaunch("test", "asked to");
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(3, rig.Vehicle.Count(VehicleCommandKind.Return));
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Land));
    }

    [Fact]
    public void Return_MakesNoProgress_IsCommandedAgainThenLands()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Returning);
        rig.Vehicle.CanMove = false;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd(300));
        Assert.Equal(2, rig.Vehicle.Count(VehicleCommandKind.Return));
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Land));
    }

    [Fact]
    public void Search_WindLeavesHardlyAnyProgress_ReturnsToLaunch()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.MaxSpeed = 0.3;
        Assert.Equal(MissionPhase.Returning, rig.RunUntil(MissionPhase.Returning, 300));
        Assert.EndsWith("takes too long", rig.Status.Aborted!, StringComparison.Ordinal);
    }

    [Fact]
    public void Landing_AutopilotDoesNotDisarm_IsDisarmed()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Returning);
        rig.Vehicle.DisarmsItself = false;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Disarm));
    }

    [Fact]
    public void Landing_NeverComesDown_EndsAsFailed()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Landing);
        rig.Vehicle.CanClimb = false;
        Assert.Equal(MissionPhase.Failed, rig.RunToEnd(600));
        Assert.StartsWith("not landed within", rig.Status.Text!, StringComparison.Ordinal);
    }
}
