using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Everything that goes wrong: each ends as it should, and nothing hangs.</summary>
public class MissionFaultTests(ITestOutputHelper output)
{
    public static readonly TheoryData<MissionPhase> PhasesInTheAir
        = [MissionPhase.TakingOff, MissionPhase.InTransit, MissionPhase.Searching, MissionPhase.Revisiting];

    public static readonly TheoryData<MissionPhase> AllPhases
        = [MissionPhase.WaitingForVehicle, MissionPhase.Arming, MissionPhase.TakingOff, MissionPhase.InTransit,
            MissionPhase.Searching, MissionPhase.Revisiting, MissionPhase.Returning, MissionPhase.Landing];

    [Theory]
    [MemberData(nameof(AllPhases))]
    public void Pilot_TakesOverInAnyPhase_NothingMoreIsCommanded(MissionPhase phase)
    {
        using MissionRig rig = RigIn(phase);
        rig.Vehicle.TakeOver("mode LOITER");
        rig.Run(1);
        int commands = rig.Vehicle.Commands.Count;
        rig.Run(120);
        output.WriteLine(rig.Story);
        Assert.Equal(MissionPhase.HandedOver, rig.Status.Phase);
        Assert.Equal("mode LOITER", rig.Status.Text);
        Assert.Equal(commands, rig.Vehicle.Commands.Count);
    }

    [Theory]
    [MemberData(nameof(PhasesInTheAir))]
    public void Abort_InTheAir_ReturnsToLaunch(MissionPhase phase)
    {
        using MissionRig rig = RigIn(phase);
        rig.Manager.Abort("asked to");
        rig.Manager.Abort("a second time");
        Assert.Equal(MissionPhase.Returning, rig.RunUntil(MissionPhase.Returning, 1));
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal("asked to", rig.Status.Aborted);
        Assert.InRange(rig.Vehicle.North, -2, 2);
    }

    [Theory]
    [InlineData(MissionPhase.WaitingForVehicle)]
    [InlineData(MissionPhase.Arming)]
    public void Abort_BeforeTakeOff_StaysOnTheGround(MissionPhase phase)
    {
        using MissionRig rig = RigIn(phase);
        rig.Manager.Abort("asked to");
        rig.Run(30);
        Assert.Equal(MissionPhase.Failed, rig.Status.Phase);
        Assert.Equal(0, rig.Vehicle.Height);
        Assert.False(rig.Vehicle.IsArmed);
        Assert.Equal("given up before take-off: asked to", rig.Status.Text);
    }

    [Theory]
    [MemberData(nameof(PhasesInTheAir))]
    public void Health_AdvisesReturnToLaunch_ReturnsToLaunch(MissionPhase phase)
    {
        using MissionRig rig = RigIn(phase);
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
    [MemberData(nameof(PhasesInTheAir))]
    [InlineData(MissionPhase.Returning)]
    public void Health_AdvisesLand_LandsWhereItIs(MissionPhase phase)
    {
        using MissionRig rig = RigIn(phase);
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
    public void Health_CriticalAtStart_Waits()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.Health = new HealthReport { Level = HealthLevel.Critical, Text = "manager 'x' faulted" };
        rig.Run(30);
        Assert.Equal("waiting: manager 'x' faulted", rig.Status.Text);
        rig.Vehicle.Health = new HealthReport { Level = HealthLevel.Good };
        Assert.Equal(MissionPhase.TakingOff, rig.RunUntil(MissionPhase.TakingOff, 20));
    }

    [Fact]
    public void Vehicle_LostAndBack_GoesOnWithoutAPileOfCommands()
    {
        using MissionRig rig = RigIn(MissionPhase.Searching);
        rig.Run(8);
        rig.Vehicle.IsConnected = false;
        rig.Run(4);
        int commands = rig.Vehicle.Commands.Count;
        rig.Run(100);
        Assert.Equal(MissionPhase.Searching, rig.Status.Phase);
        Assert.Equal("autopilot not connected", rig.Status.Text);
        Assert.InRange(rig.Vehicle.Commands.Count - commands, 0, 1);
        rig.Vehicle.IsConnected = true;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Null(rig.Status.Aborted);
        Assert.InRange(rig.Status.Coverage, 0.985, 1);
    }

    [Fact]
    public void Vehicle_LostAndBackWithAdvice_FollowsIt()
    {
        using MissionRig rig = RigIn(MissionPhase.Searching);
        rig.Vehicle.IsConnected = false;
        rig.Run(4);
        rig.Vehicle.Health = new HealthReport
        {
            Level = HealthLevel.Critical,
            Text = "autopilot lost",
            Advice = HealthAdvice.ReturnToLaunch
        };
        rig.Run(20);
        Assert.Equal(0, rig.Vehicle.Count(VehicleCommandKind.Return));
        rig.Vehicle.IsConnected = true;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal("health: autopilot lost", rig.Status.Aborted);
    }

    [Fact]
    public void Vehicle_LostForGood_EndsAsFailed()
    {
        using MissionRig rig = RigIn(MissionPhase.Searching);
        rig.Vehicle.IsConnected = false;
        Assert.Equal(MissionPhase.Failed, rig.RunToEnd(320));
    }

    [Fact]
    public void Vehicle_LosesItsPosition_LandsAfterAWhile()
    {
        using MissionRig rig = RigIn(MissionPhase.Searching);
        rig.Vehicle.HasPosition = false;
        rig.Run(10);
        Assert.Equal(0, rig.Vehicle.Count(VehicleCommandKind.Land));
        Assert.Equal(MissionPhase.Done, rig.RunToEnd(120));
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Land));
    }

    [Fact]
    public void Fence_VehicleIsBlownOut_ReturnsToLaunch()
    {
        using MissionRig rig = RigIn(MissionPhase.Searching);
        rig.Vehicle.North += 200;
        rig.Run(3);
        Assert.Equal(MissionPhase.Returning, rig.Status.Phase);
        Assert.Contains("m outside the fence", rig.Status.Aborted!, StringComparison.Ordinal);
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
    }

    [Theory]
    [MemberData(nameof(PhasesInTheAir))]
    public void Motors_StopInFlight_IsFailed(MissionPhase phase)
    {
        using MissionRig rig = RigIn(phase);
        if (phase == MissionPhase.TakingOff)
            rig.Run(3);
        rig.Vehicle.IsArmed = false;
        int commands = rig.Vehicle.Commands.Count;
        rig.Run(5);
        Assert.Equal(MissionPhase.Failed, rig.Status.Phase);
        Assert.StartsWith("the motors stopped at a height of", rig.Status.Text!, StringComparison.Ordinal);
        Assert.InRange(rig.Vehicle.Commands.Count - commands, 0, 1);
    }

    [Fact]
    public void Vehicle_LandsUnexpectedly_IsFailedAndDisarmed()
    {
        using MissionRig rig = RigIn(MissionPhase.Searching);
        rig.Vehicle.CanClimb = false;
        rig.Vehicle.Height = 0;
        rig.Run(10);
        Assert.Equal(MissionPhase.Failed, rig.Status.Phase);
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Disarm));
    }

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
        using MissionRig rig = RigIn(MissionPhase.TakingOff);
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
        using MissionRig rig = RigIn(MissionPhase.Searching);
        rig.Vehicle.Refuses = c => c.Kind == VehicleCommandKind.Return ? VehicleCommandOutcome.Refused : null;
        rig.Manager.Abort("asked to");
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(3, rig.Vehicle.Count(VehicleCommandKind.Return));
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Land));
    }

    [Fact]
    public void Return_MakesNoProgress_IsCommandedAgainThenLands()
    {
        using MissionRig rig = RigIn(MissionPhase.Returning);
        rig.Vehicle.CanMove = false;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd(300));
        Assert.Equal(2, rig.Vehicle.Count(VehicleCommandKind.Return));
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Land));
    }

    [Fact]
    public void Search_WindIsStrongerThanTheVehicle_ReturnsToLaunch()
    {
        using MissionRig rig = RigIn(MissionPhase.Searching);
        rig.Vehicle.CanMove = false;
        Assert.Equal(MissionPhase.Returning, rig.RunUntil(MissionPhase.Returning, 300));
        Assert.EndsWith("takes too long", rig.Status.Aborted!, StringComparison.Ordinal);
    }

    [Fact]
    public void Landing_AutopilotDoesNotDisarm_IsDisarmed()
    {
        using MissionRig rig = RigIn(MissionPhase.Returning);
        rig.Vehicle.DisarmsItself = false;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Disarm));
    }

    [Fact]
    public void Landing_NeverComesDown_EndsAsFailed()
    {
        using MissionRig rig = RigIn(MissionPhase.Landing);
        rig.Vehicle.CanClimb = false;
        Assert.Equal(MissionPhase.Failed, rig.RunToEnd(600));
        Assert.StartsWith("not landed within", rig.Status.Text!, StringComparison.Ordinal);
    }

    [Fact]
    public void Vehicle_ReportsNoLandedState_IsFlownAllTheSame()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.ReportsLandedState = false;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Null(rig.Status.Aborted);
    }

    [Fact]
    public void Start_FlyingAlready_IsNotTakenOver()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        (rig.Vehicle.IsArmed, rig.Vehicle.Height) = (true, 30);
        rig.Run(10);
        Assert.Equal(MissionPhase.Failed, rig.Status.Phase);
        Assert.Empty(rig.Vehicle.Commands);
    }

    [Fact]
    public void Start_ArmedOnTheGround_IsTaken()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.IsArmed = true;
        Assert.Equal(MissionPhase.TakingOff, rig.RunUntil(MissionPhase.TakingOff, 20));
    }

    [Theory]
    [InlineData("battery", "waiting: battery 40.0 %; 50.0 % are needed")]
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

    private static MissionRig RigIn(MissionPhase phase)
    {
        var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.Targets.Add((80, -30, DefaultTargetClasses.Red));
        if (phase == MissionPhase.WaitingForVehicle)
            rig.Run(1);
        if (phase == MissionPhase.Arming)
            rig.Vehicle.Refuses = c => c.Kind == VehicleCommandKind.Arm ? VehicleCommandOutcome.Refused : null;
        Assert.Equal(phase, rig.RunUntil(phase));
        if (phase == MissionPhase.TakingOff)
            rig.Run(2);
        return rig;
    }
}
