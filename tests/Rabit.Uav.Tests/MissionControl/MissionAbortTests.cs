using System;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>What ends a mission early: the pilot, an abort, the advice of Health Monitoring, the fence.</summary>
public class MissionAbortTests(ITestOutputHelper output)
{
    [Theory]
    [MemberData(nameof(MissionPhases.All), MemberType = typeof(MissionPhases))]
    public void Pilot_TakesOverInAnyPhase_NothingMoreIsCommanded(MissionPhase phase)
    {
        using MissionRig rig = MissionRig.In(phase);
        rig.Vehicle.TakeOver("mode LOITER");
        rig.Run(1);
        int commands = rig.Vehicle.Commands.Count;
        rig.Run(120);
        output.WriteLine(rig.Story);
        Assert.Equal(MissionPhase.HandedOver, rig.Status.Phase);
        Assert.Equal("the pilot took over: mode LOITER", rig.Status.Text);
        Assert.Equal(commands, rig.Vehicle.Commands.Count);
    }

    [Theory]
    [MemberData(nameof(MissionPhases.InTheAir), MemberType = typeof(MissionPhases))]
    public void OperatorReturn_InTheAir_ReturnsToLaunch(MissionPhase phase)
    {
        using MissionRig rig = MissionRig.In(phase);
        rig.Manager.ReturnToLaunch("test", "asked to");
        Assert.Equal(MissionPhase.Returning, rig.RunUntil(MissionPhase.Returning, 1));
        rig.Manager.ReturnToLaunch("test", "a second time");
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal("asked to", rig.Status.Aborted);
        Assert.InRange(rig.Vehicle.North, -2, 2);
    }

    [Theory]
    [InlineData(MissionPhase.WaitingForVehicle)]
    [InlineData(MissionPhase.Arming)]
    public void OperatorReturn_BeforeTakeOff_StaysOnTheGround(MissionPhase phase)
    {
        using MissionRig rig = MissionRig.In(phase);
        rig.Manager.ReturnToLaunch("test", "asked to");
        rig.Run(30);
        Assert.Equal(MissionPhase.Failed, rig.Status.Phase);
        Assert.Equal(0, rig.Vehicle.Height);
        Assert.False(rig.Vehicle.IsArmed);
        Assert.Equal("given up before take-off: asked to", rig.Status.Text);
    }

    [Theory]
    [MemberData(nameof(MissionPhases.InTheAir), MemberType = typeof(MissionPhases))]
    public void Health_AdvisesReturnToLaunch_ReturnsToLaunch(MissionPhase phase)
    {
        using MissionRig rig = MissionRig.In(phase);
        rig.Vehicle.Health = new HealthReport
        {
            Level = HealthLevel.Warning,
            Text = "battery low (20 %)",
            Advice = HealthAdvice.ReturnToLaunch
        };
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal("health: battery low (20 %)", rig.Status.Aborted);
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Return));
        Assert.InRange(rig.Vehicle.North, -2, 2);
    }

    [Theory]
    [MemberData(nameof(MissionPhases.InTheAir), MemberType = typeof(MissionPhases))]
    [InlineData(MissionPhase.Returning)]
    public void Health_AdvisesLand_LandsWhereItIs(MissionPhase phase)
    {
        using MissionRig rig = MissionRig.In(phase);
        double north = rig.Vehicle.North;
        rig.Vehicle.Health = new HealthReport
        {
            Level = HealthLevel.Critical,
            Text = "battery nearly empty",
            Advice = HealthAdvice.Land
        };
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Land));
        Assert.InRange(rig.Vehicle.North, north - 15, north + 15);
    }

    [Fact]
    public void Fence_VehicleIsBlownOut_ReturnsToLaunch()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.North += 200;
        rig.Run(3);
        Assert.Equal(MissionPhase.Returning, rig.Status.Phase);
        Assert.Contains("m outside the fence", rig.Status.Aborted!, StringComparison.Ordinal);
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
    }
}
