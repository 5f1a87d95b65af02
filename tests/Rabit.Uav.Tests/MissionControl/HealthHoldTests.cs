using System;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Health Monitoring advises to hold: it is held until the reason ends, and the mission continues.</summary>
public class HealthHoldTests
{
    private static readonly HealthReport Good = new() { Level = HealthLevel.Good };

    private static readonly HealthReport Hold = new()
    {
        Level = HealthLevel.Warning,
        Text = "pictures unusable",
        Advice = HealthAdvice.Hold,
        AdviceText = "pictures unusable",
    };

    [Theory]
    [MemberData(nameof(MissionPhases.InTheAir), MemberType = typeof(MissionPhases))]
    public void Advice_Hold_HoldsAndContinuesByItself(MissionPhase phase)
    {
        using MissionRig rig = MissionRig.In(phase);
        rig.Vehicle.Health = Hold;
        rig.Run(4);
        (double north, double east) = (rig.Vehicle.North, rig.Vehicle.East);
        rig.Run(30);
        Assert.Equal(
            (MissionPhase.Holding, "holding: health: pictures unusable"), (rig.Status.Phase, rig.Status.Text));
        Assert.Equal((north, east), (rig.Vehicle.North, rig.Vehicle.East));

        rig.Vehicle.Health = Good;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(MissionOutcome.Accomplished, rig.Status.Result.Outcome);
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Hold));
        Assert.InRange(rig.Status.Coverage, 0.985, 1);
    }

    [Fact]
    public void Advice_HoldDuringTheReturn_IsNotFollowed()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Returning);
        rig.Vehicle.Health = Hold;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(0, rig.Vehicle.Count(VehicleCommandKind.Hold));
    }

    [Fact]
    public void Advice_BecomesMoreSevere_IsFollowed()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.Health = Hold;
        rig.Run(5);
        rig.Vehicle.Health = new HealthReport { Text = "battery low", Advice = HealthAdvice.ReturnToLaunch };
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal("health: battery low", rig.Status.Aborted);
    }

    [Fact]
    public void Advice_HoldDoesNotEnd_ReturnsAfterTwoMinutes()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.Health = Hold;
        rig.Run(115);
        Assert.Equal(MissionPhase.Holding, rig.Status.Phase);
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal("health: pictures unusable", rig.Status.Aborted);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void OperatorsHold_BeforeOrDuringThatOfHealth_IsNotEndedWithIt(bool isFirst)
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        if (isFirst)
            rig.Manager.Hold("test", "a walker");
        rig.Run(3);
        rig.Vehicle.Health = Hold;
        rig.Run(3);
        if (!isFirst)
            rig.Manager.Hold("test", "a walker");
        rig.Run(3);
        rig.Vehicle.Health = Good;
        rig.Run(30);
        Assert.Equal((MissionPhase.Holding, "holding: a walker"), (rig.Status.Phase, rig.Status.Text));
        rig.Manager.ContinueMission("test", "clear");
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
    }

    [Fact]
    public void Resume_AgainstTheHoldOfHealth_IsRefused()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.Health = Hold;
        rig.Run(3);
        rig.Manager.ContinueMission("test", "test");
        rig.Run(3);
        Assert.Equal(MissionPhase.Holding, rig.Status.Phase);
        Assert.Contains("continue refused: health: pictures unusable", rig.Story, StringComparison.Ordinal);
        rig.Manager.ReturnToLaunch("test", "enough");
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
    }

    [Fact]
    public void Stop_InTheHoldOfHealth_DoesNotContinue()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.Health = Hold;
        rig.Run(3);
        rig.Vehicle.Health = Good;
        rig.Stop();
        Assert.Equal((MissionPhase.Holding, MissionStopResult.Held), (rig.Status.Phase, rig.Status.StopResult));
    }
}
