using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>What Mission Control sees by itself, and how it shows that it works.</summary>
public class MissionGuardTests
{
    [Fact]
    public void Command_WholeFlight_IsRenewedEverySecondWithAValidity()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Run(20);
        rig.Manager.Hold("test", "test");
        rig.Run(30);
        rig.Manager.ContinueMission("test", "test");
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());

        TimeSpan[] times = rig.Vehicle.Commands.Concat(rig.Vehicle.Renewals).Select(c => c.Time).OrderBy(t => t)
            .ToArray();
        Assert.All(times.Zip(times.Skip(1), (a, b) => b - a), gap => Assert.True(gap <= TimeSpan.FromSeconds(1.1)));
        Assert.All(
            rig.Vehicle.Commands.Concat(rig.Vehicle.Renewals),
            c => Assert.Equal(TimeSpan.FromSeconds(3), c.Command.Validity));
    }

    [Fact]
    public void Renewal_AfterATakeover_Ends()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.TakeOver("mode LOITER");
        rig.Run(2);
        int renewals = rig.Vehicle.Renewals.Count;
        rig.Run(20);
        Assert.Equal(renewals, rig.Vehicle.Renewals.Count);
    }

    [Theory]
    [InlineData(MavState.Critical)]
    [InlineData(MavState.Emergency)]
    public void SystemStatus_CriticalWhileTheModeIsOurs_ReturnsAtOnce(MavState status)
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Run(5);
        rig.Vehicle.SystemStatus = status;
        Assert.Equal(MissionPhase.Returning, rig.RunUntil(MissionPhase.Returning, 0.6));
        Assert.StartsWith("the autopilot reports", rig.Status.Aborted!, StringComparison.Ordinal);
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
    }

    [Theory]
    [MemberData(nameof(MissionPhases.InTheAir), MemberType = typeof(MissionPhases))]
    public void HealthReport_Stale_Returns(MissionPhase phase)
    {
        using MissionRig rig = MissionRig.In(phase);
        rig.Vehicle.HealthHangs = true;
        rig.Run(4.5);
        Assert.NotEqual(MissionPhase.Returning, rig.Status.Phase);
        Assert.Equal(MissionPhase.Returning, rig.RunUntil(MissionPhase.Returning, 1.5));
        Assert.StartsWith("no health report for 5", rig.Status.Aborted!, StringComparison.Ordinal);
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Return));
    }

    [Fact]
    public void HealthReport_StaleAfterATakeover_NothingIsCommanded()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.TakeOver("mode LOITER");
        rig.Vehicle.HealthHangs = true;
        rig.Run(20);
        Assert.Equal(MissionPhase.HandedOver, rig.Status.Phase);
        Assert.Equal(0, rig.Vehicle.Count(VehicleCommandKind.Return));
    }

    [Fact]
    public void AutopilotInterface_HangsAndComesBack_IsNoLossOfThePosition()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Run(5);
        rig.Vehicle.Hangs = true;
        rig.Run(10);
        Assert.Equal("Autopilot Interface reports nothing", rig.Status.Text);
        rig.Vehicle.Health = new HealthReport { Text = "hangs", Advice = HealthAdvice.ReturnToLaunch };
        rig.Run(30);
        rig.Vehicle.Hangs = false;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(0, rig.Vehicle.Count(VehicleCommandKind.Land));
        Assert.InRange(rig.Vehicle.North, -2, 2);
    }

    [Fact]
    public void AutopilotInterface_ReturnedByItself_MissionReturns()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Run(5);
        rig.Vehicle.Authority = new CommandAuthority
        {
            State = CommandAuthorityState.Ours,
            IsReturningByItself = true
        };
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.StartsWith("Autopilot Interface returned by itself", rig.Status.Aborted!, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("\"maxHeightMetres\": 45", "height 60.0 m, above the limit of 45.0 m")]
    [InlineData("\"maxDistanceMetres\": 190", "m from home, beyond the limit of 190.0 m")]
    public void Limits_Exceeded_Returns(string limit, string reason)
    {
        using var rig = new MissionRig(MissionRig.Mission($", \"limits\": {{ {limit} }}, \"fenceMarginMetres\": 500"));
        Assert.Equal(MissionPhase.Searching, rig.RunUntil(MissionPhase.Searching));
        if (reason.StartsWith("height", StringComparison.Ordinal))
            (rig.Vehicle.Height, rig.Vehicle.CanClimb) = (60, false);
        else
            rig.Vehicle.North += 200;
        Assert.Equal(MissionPhase.Returning, rig.RunUntil(MissionPhase.Returning, 5));
        Assert.Contains(reason, rig.Status.Aborted!, StringComparison.Ordinal);
    }

    [Fact]
    public void Limits_LanesBeyondTheDistance_AreRefusedAtThePlan()
    {
        using var rig = new MissionRig(MissionRig.Mission(", \"limits\": { \"maxDistanceMetres\": 150 }"));
        rig.Run(10);
        Assert.Equal(MissionPhase.Failed, rig.Status.Phase);
        Assert.Contains("limits.maxDistanceMetres, 150.0 m", rig.Status.Text!, StringComparison.Ordinal);
    }

    [Fact]
    public void Limits_HeightsAbove_AreFaultsOfTheFile()
    {
        string text = MissionRig.Text(
            ", \"limits\": { \"maxHeightMetres\": 41 }, \"revisit\": { \"heightMetres\": 50 }");
        MissionPlanException fault = Assert.Throws<MissionPlanException>(() => MissionPlan.Parse(text, "m"));
        Assert.Contains("heightMetres is 40; it must be 2 below limits.maxHeightMetres, 41", fault.Message,
            StringComparison.Ordinal);
        Assert.Contains("revisit.heightMetres is 50", fault.Message, StringComparison.Ordinal);
    }
}
