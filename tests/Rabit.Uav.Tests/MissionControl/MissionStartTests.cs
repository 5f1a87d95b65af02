using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>What a mission waits for before it starts, and what it does not start with.</summary>
public class MissionStartTests
{
    [Fact]
    public void Health_CriticalAtStart_Waits()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.Health = new HealthReport { Level = HealthLevel.Critical, Text = "manager 'x' faulted" };
        rig.Run(30);
        Assert.Equal("waiting: manager 'x' faulted", rig.Status.Text);
        rig.Vehicle.Health = new HealthReport { Level = HealthLevel.Good };
        Assert.Equal(MissionPhase.TakingOff, rig.RunUntil(MissionPhase.TakingOff, 20));
    }

    [Theory]
    [InlineData(HealthReasons.WindHigh, true, true)]
    [InlineData(HealthReasons.GroundStationLost, true, true)]
    [InlineData(HealthReasons.GroundStationLost, false, false)]
    [InlineData(HealthReasons.DiskLow, true, false)]
    public void Start_WindOrGroundStation_IsWaitedForWithItsFigures(
        HealthReasons reason, bool needsGroundStation, bool waits)
    {
        string more = needsGroundStation ? string.Empty : ",\"groundStationLost\":{\"action\":\"continue\"}";
        using var rig = new MissionRig(MissionRig.Mission(more));
        rig.Vehicle.Health = new HealthReport
        {
            Level = HealthLevel.Warning,
            Reasons = reason,
            Text = "wind too strong (15 m/s)",
        };
        rig.Run(30);
        Assert.Equal(waits, rig.Status.Text == "waiting: wind too strong (15 m/s)");
        Assert.Equal(waits, rig.Status.Phase == MissionPhase.WaitingForVehicle);
        if (!waits)
            return;
        rig.Vehicle.Health = new HealthReport { Level = HealthLevel.Good };
        Assert.Equal(MissionPhase.TakingOff, rig.RunUntil(MissionPhase.TakingOff, 20));
    }

    [Fact]
    public void Start_FlyingAlready_IsNotTakenOver()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        (rig.Vehicle.IsArmed, rig.Vehicle.Height) = (true, 30);
        rig.Run(60);
        Assert.Equal(MissionPhase.HandedOver, rig.Status.Phase);
        Assert.Empty(rig.Vehicle.Commands);
        Assert.Equal(MissionFailures.GivenUp, rig.Status.Result.Failures & MissionFailures.GivenUp);
    }

    [Fact]
    public void Start_ArmedOnTheGround_IsTaken()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.IsArmed = true;
        Assert.Equal(MissionPhase.TakingOff, rig.RunUntil(MissionPhase.TakingOff, 20));
    }

    [Fact]
    public void Start_UnknownBatteryThatTheMissionAllows_Begins()
    {
        using var rig = new MissionRig(MissionRig.Mission(", \"limits\": { \"allowUnknownBattery\": true }"));
        rig.Vehicle.Battery = double.NaN;
        Assert.Equal(MissionPhase.TakingOff, rig.RunUntil(MissionPhase.TakingOff, 20));
    }

    [Theory]
    [InlineData("battery", "waiting: battery 40.0 %; 50.0 % are needed")]
    [InlineData("unknown battery",
        "waiting: the charge of the battery is not known (limits.allowUnknownBattery of the mission)")]
    [InlineData("fix", "waiting: no satellite fix")]
    [InlineData("position", "waiting: no position")]
    [InlineData("camera", "waiting: no camera")]
    [InlineData("silent", "waiting: no autopilot connected")]
    [InlineData("observing", "waiting: we only observe, and may not command")]
    public void Start_SomethingIsMissing_WaitsAndThenFails(string what, string text)
    {
        using var rig = new MissionRig(MissionRig.Mission(), o => o.ReadyTimeout = TimeSpan.FromSeconds(40));
        switch (what)
        {
            case "battery":
                rig.Vehicle.Battery = 0.4;
                break;
            case "unknown battery":
                rig.Vehicle.Battery = double.NaN;
                break;
            case "fix":
                rig.Vehicle.Fix = GpsFixType.Type2dFix;
                break;
            case "position":
                rig.Vehicle.HasPosition = false;
                break;
            case "camera":
                rig.Vehicle.HasCamera = false;
                break;
            case "silent":
                rig.Vehicle.IsConnected = false;
                break;
            default:
                rig.Vehicle.Authority = new CommandAuthority { State = CommandAuthorityState.Observing };
                break;
        }

        rig.Run(30);
        Assert.Equal((MissionPhase.WaitingForVehicle, text), (rig.Status.Phase, rig.Status.Text));
        rig.Run(20);
        Assert.Equal(MissionPhase.Failed, rig.Status.Phase);
        Assert.Empty(rig.Vehicle.Commands);
    }

    [Fact]
    public void Start_FarFromTheMissionsHome_IsFailed()
    {
        using var rig = new MissionRig(
            MissionRig.Mission(", \"home\": {\"latitudeDegrees\": 47.3987, \"longitudeDegrees\": 8.5456}"));
        rig.Run(10);
        Assert.Equal(MissionPhase.Failed, rig.Status.Phase);
        Assert.StartsWith("the vehicle is 111.2 m from the mission's home", rig.Status.Text!, StringComparison.Ordinal);
    }

    [Fact]
    public void Autopilot_ComesMinutesAfterTheProgram_MissionIsFlown()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.IsConnected = false;
        rig.Run(150);
        rig.Vehicle.IsConnected = true;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Null(rig.Status.Aborted);
    }
}
