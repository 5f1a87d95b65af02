using System;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>
/// A crash is never reported as a landing, nor a landing as a crash, and a place that is not known is not home.
/// </summary>
public class TouchdownTests
{
    [Fact]
    public void Landing_PositionLostForGood_IsALandingAtAnUnknownPlace()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.HasPosition = false;

        Assert.Equal(MissionPhase.Done, rig.RunToEnd(200));
        MissionResult result = rig.Status.Result;
        Assert.Equal("landed at an unknown place", rig.Status.Text);
        Assert.True(result.HasLanded);
        Assert.Equal(
            MissionFailures.GivenUp | MissionFailures.AwayFromHome | MissionFailures.AreaNotSeen, result.Failures);
        Assert.True(double.IsNaN(result.DistanceFromHomeMetres));
    }

    [Fact]
    public void Landing_EstimatorWithoutAPosition_IsNotALandingAtHome()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Landing);
        rig.Vehicle.HasValidPosition = false;

        Assert.Equal(MissionPhase.Done, rig.RunToEnd(100));
        Assert.Equal("landed at an unknown place", rig.Status.Text);
        Assert.Equal(
            (MissionOutcome.Failed, MissionFailures.AwayFromHome),
            (rig.Status.Result.Outcome, rig.Status.Result.Failures));
    }

    [Fact]
    public void Landing_PlaceKnownAgainAfterTheMotorsStopped_StaysUnknown()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Landing);
        rig.Vehicle.HasValidPosition = false;
        rig.RunToEnd(100);
        rig.Vehicle.HasValidPosition = true;
        rig.Run(5);

        Assert.Equal(MissionFailures.AwayFromHome, rig.Status.Result.Failures);
    }

    [Theory]
    [InlineData(MissionPhase.Searching)]
    [InlineData(MissionPhase.Landing)]
    public void Fall_DisarmedOnTheGround_IsNotALanding(MissionPhase phase)
    {
        using MissionRig rig = MissionRig.In(phase);
        rig.Vehicle.Falls = true;
        rig.Vehicle.Health = new HealthReport
        {
            Level = HealthLevel.Critical,
            Text = "battery 0 %",
            Advice = HealthAdvice.Land,
        };
        rig.RunToEnd(60);
        rig.Run(2);

        Assert.Equal(MissionPhase.Failed, rig.Status.Phase);
        Assert.StartsWith("the vehicle fell, at", rig.Status.Text!, StringComparison.Ordinal);
        Assert.False(rig.Status.Result.HasLanded);
        Assert.True((rig.Status.Result.Failures & MissionFailures.NotLanded) != 0);
    }

    [Fact]
    public void MotorsStop_InTheAirAfterATakeover_IsNotALanding()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.TakeOver("mode STABILIZE");
        rig.Run(2);
        rig.Vehicle.IsArmed = false;
        rig.Run(3);

        Assert.False(rig.Status.Result.HasLanded);
        Assert.Equal(
            MissionFailures.NotLanded | MissionFailures.TakenOver | MissionFailures.AreaNotSeen,
            rig.Status.Result.Failures);
    }

    [Fact]
    public void MotorsStop_WithoutLandedStateAndHeightOfThatMoment_IsNotALanding()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Landing);
        (rig.Vehicle.ReportsLandedState, rig.Vehicle.HasPosition) = (false, false);
        rig.Run(4);
        rig.Vehicle.IsArmed = false;
        rig.Run(3);

        Assert.Equal(MissionPhase.Failed, rig.Status.Phase);
        Assert.Equal("the motors stopped, and neither landed state nor height says where", rig.Status.Text);
        Assert.False(rig.Status.Result.HasLanded);
    }
}
