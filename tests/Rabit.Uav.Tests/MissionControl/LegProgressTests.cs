using System;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>A vehicle that does not come nearer to where it was commanded.</summary>
public class LegProgressTests
{
    [Theory]
    [InlineData(8, 2)]
    [InlineData(2, 5)]
    public void NoProgress_VehicleStands_IsCommandedAgainThenHoldsThenReturns(double speed, double withinSeconds)
    {
        using MissionRig rig = InALane(speed);
        rig.Vehicle.CanMove = false;
        // The braking ends first: 8 m/s at 2.5 m/s2.
        rig.Run(3.5);
        int before = rig.Vehicle.Commands.Count;
        rig.Run(withinSeconds + 0.6 - (speed > 3 ? 0 : 3));
        Assert.Contains("no progress along the leg: commanded again", rig.Story, StringComparison.Ordinal);
        Assert.True(rig.Vehicle.Commands.Count >= before);

        Assert.Equal(MissionPhase.Holding, rig.RunUntil(MissionPhase.Holding, withinSeconds + 1));
        Assert.Equal("holding: no progress along the leg", Latest(rig));
        rig.Vehicle.CanMove = true;
        Assert.Equal(MissionPhase.Returning, rig.RunUntil(MissionPhase.Returning, 20));
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal("no progress along the leg", rig.Status.Aborted);
    }

    [Fact]
    public void NoProgress_PilotsSwitchThereAndBack_TheLegIsCommandedAgainAndFlown()
    {
        using MissionRig rig = InALane(8);
        rig.Vehicle.ForgetTask();
        rig.Run(8);
        Assert.Equal(MissionPhase.Searching, rig.Status.Phase);
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Null(rig.Status.Aborted);
    }

    [Fact]
    public void NoProgress_OperatorContinuesInTheHold_TheMissionGoesOn()
    {
        using MissionRig rig = InALane(8);
        rig.Vehicle.CanMove = false;
        Assert.Equal(MissionPhase.Holding, rig.RunUntil(MissionPhase.Holding, 15));
        rig.Vehicle.CanMove = true;
        rig.Manager.ContinueMission("test", "it was the wind");
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(MissionOutcome.Accomplished, rig.Status.Result.Outcome);
    }

    [Fact]
    public void NoProgress_OperatorHolds_OurOwnHoldDoesNotEndIt()
    {
        using MissionRig rig = InALane(8);
        rig.Vehicle.CanMove = false;
        Assert.Equal(MissionPhase.Holding, rig.RunUntil(MissionPhase.Holding, 15));
        rig.Manager.Hold("test", "wait");
        rig.Run(60);
        Assert.Equal((MissionPhase.Holding, "holding: wait"), (rig.Status.Phase, rig.Status.Text));
    }

    private static string Latest(MissionRig rig)
    {
        rig.Run(1.2);
        return rig.Status.Text!;
    }

    private static MissionRig InALane(double speed)
    {
        MissionPlan mission = MissionPlan.Parse(
            MissionRig.Text().Replace(
                "\"speedMetresPerSecond\":8",
                FormattableString.Invariant($"\"speedMetresPerSecond\":{speed}")), "test");
        var rig = new MissionRig(mission);
        Assert.Equal(MissionPhase.Searching, rig.RunUntil(MissionPhase.Searching));
        rig.Run(8);
        return rig;
    }
}
