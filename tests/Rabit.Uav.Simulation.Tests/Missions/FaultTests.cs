using System;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>
/// What goes wrong in flight, and how the flight ends: as the table of Health Monitoring says, and never hanging.
/// </summary>
public sealed class FaultTests(ITestOutputHelper output)
{
    private static readonly TimeSpan InTheLanes = TimeSpan.FromSeconds(50);
    private static readonly TimeSpan TestTimeout = TimeSpan.FromMinutes(10);

    [Fact]
    public void Search_NothingGoesWrong_IsDone()
    {
        using SearchFlight flight = Fly();

        Assert.Null(flight.Mission.Aborted);
        AssertLandedAtHome(flight);
    }

    [Fact]
    public void LinkSilent_ForTwoSeconds_IsNoReasonToReturn()
    {
        using SearchFlight flight = Fly(Fault(ScriptedFaultKind.LinkSilent, 0, seconds: 2));

        Assert.Null(flight.Mission.Aborted);
        AssertLandedAtHome(flight);
    }

    [Fact]
    public void LinkSilent_ForLong_ReturnsToLaunchOnceItIsBack()
    {
        using SearchFlight flight = Fly(Fault(ScriptedFaultKind.LinkSilent, 0, seconds: 15));

        Assert.Contains("autopilot", flight.Mission.Aborted, StringComparison.Ordinal);
        AssertLandedAtHome(flight);
    }

    [Fact]
    public void BatteryLow_InALane_ReturnsToLaunch()
    {
        using SearchFlight flight = Fly(Fault(ScriptedFaultKind.BatteryTo, 0.20));

        Assert.Contains("battery", flight.Mission.Aborted, StringComparison.Ordinal);
        AssertLandedAtHome(flight);
    }

    [Fact]
    public void BatteryCritical_InALaneNearHome_ReturnsToLaunch()
    {
        using SearchFlight flight = Fly(Fault(ScriptedFaultKind.BatteryTo, 0.08));

        Assert.Contains("needed for the way home", flight.Mission.Aborted, StringComparison.Ordinal);
        AssertLandedAtHome(flight);
    }

    [Fact]
    public void BatteryEmpty_InALane_IsACrashAndNoLanding()
    {
        using SearchFlight flight = Fly(Fault(ScriptedFaultKind.BatteryTo, 0));

        Assert.True(flight.World.Truth.HasCrashed);
        Assert.False(flight.Mission.Result.HasLanded);
        Assert.Equal(MissionPhase.Failed, flight.Mission.Phase);
        Assert.StartsWith("the vehicle fell", flight.Mission.Text, StringComparison.Ordinal);
    }

    [Fact]
    public void CameraFreeze_InALane_ReturnsToLaunch()
    {
        using SearchFlight flight = Fly(Fault(ScriptedFaultKind.CameraFreeze, 0, seconds: 1000));

        Assert.Contains("camera", flight.Mission.Aborted, StringComparison.Ordinal);
        AssertLandedAtHome(flight);
    }

    [Fact]
    public void CameraFreeze_Short_IsNoReasonToReturn()
    {
        using SearchFlight flight = Fly(Fault(ScriptedFaultKind.CameraFreeze, 0, seconds: 1.5));

        Assert.Null(flight.Mission.Aborted);
        AssertLandedAtHome(flight);
    }

    [Fact]
    public void Wind_AboveTheLimit_ReturnsToLaunch()
    {
        using SearchFlight flight = Fly(Fault(ScriptedFaultKind.WindTo, 15));

        Assert.Contains("wind", flight.Mission.Aborted, StringComparison.Ordinal);
        AssertLandedAtHome(flight);
    }

    [Fact]
    public void Wind_AboveTheLimitBeforeTakeOff_IsWaitedForWithItsFigure()
    {
        ScriptedFault storm = Fault(ScriptedFaultKind.WindTo, 18, seconds: 60);
        storm.At = TimeSpan.Zero;
        using var flight = new SearchFlight(SearchFlight.SmallPlan(), SearchFlight.SmallWorld(storm));
        flight.FlyUntil(f => f.Mission.Text?.Contains("too strong") == true, TimeSpan.FromSeconds(40));
        Assert.Matches(@"^waiting: (wind|gusts) too strong \(\d\d m/s\)$", flight.Mission.Text);
        flight.FlyUntil(f => f.Mission.Phase != MissionPhase.WaitingForVehicle, TimeSpan.FromMinutes(3));
        Assert.Equal(MissionPhase.Arming, flight.Mission.Phase);
        Assert.InRange(flight.Reactor.Now.TotalSeconds, 65, 120);
        flight.End();
    }

    [Fact]
    public void Manager_ThrowsOnce_ReturnsToLaunch()
    {
        var payload = new PayloadManager(throwsAt: InTheLanes) { FaultPolicy = FaultPolicy.CarryOn };
        using SearchFlight flight = Fly(new SearchFlight(SearchFlight.SmallPlan(), SearchFlight.SmallWorld(), payload));

        Assert.Contains("payload", flight.Mission.Aborted, StringComparison.Ordinal);
        AssertLandedAtHome(flight);
    }

    [Fact]
    public void Manager_StatusGrowsOld_ReturnsToLaunch()
    {
        // Its work takes 30 s and it says that it sleeps 40 s in between, so 45 s after its first run it is stuck.
        var time = new VirtualTime(seed: 5);
        time.SetUnitOfWorkDuration(PayloadManager.ManagerName, TimeSpan.FromSeconds(30));
        var payload = new PayloadManager(throwsAt: TimeSpan.MaxValue, sleepsFor: TimeSpan.FromSeconds(40))
        {
            HangPolicy = HangPolicy.Off
        };
        using SearchFlight flight = Fly(
            new SearchFlight(SearchFlight.SmallPlan(), SearchFlight.SmallWorld(), time, [payload]));

        Assert.Contains("payload", flight.Mission.Aborted, StringComparison.Ordinal);
        AssertLandedAtHome(flight);
    }

    [Fact]
    public void Manager_HangsForLong_IsFoundByTheWatchdogAndReturnsToLaunch()
    {
        using SearchFlight flight = Fly(Hang("sensor fusion", seconds: 20));

        Assert.Contains("manager sensor fusion hangs (since 50.", flight.Mission.Aborted, StringComparison.Ordinal);
        AssertLandedAtHome(flight);
        ManagerResult fusion = flight.Result!.Managers.Single(m => m.Name == "sensor fusion");
        ManagerHang hang = Assert.Single(fusion.Hangs);
        Assert.Equal((ManagerStage.UnitOfWork, HangPolicy.Report.UnitOfWorkLimit), (hang.Stage, hang.Duration));
        Assert.InRange(hang.Since, InTheLanes, InTheLanes + TimeSpan.FromSeconds(2));
        Assert.Equal(ManagerOutcome.Ended, fusion.Outcome);
    }

    [Fact]
    public void Manager_HangsForAMoment_IsNoReasonToReturn()
    {
        using SearchFlight flight = Fly(Hang("sensor fusion", seconds: 4));

        Assert.Null(flight.Mission.Aborted);
        AssertLandedAtHome(flight);
    }

    [Theory]
    [InlineData(5)]    // LOITER
    [InlineData(0)]    // STABILIZE
    public void Pilot_TakesOver_NothingIsCommandedAnyMore(int mode)
    {
        using var flight = new SearchFlight(
            SearchFlight.SmallPlan(), SearchFlight.SmallWorld(Fault(ScriptedFaultKind.PilotMode, mode)));
        flight.FlyUntil(f => f.IsOver, TestTimeout);
        output.WriteLine(flight.Log);
        Assert.Equal(MissionPhase.HandedOver, flight.Mission.Phase);
        Assert.Equal(CommandAuthorityState.TakenAway, flight.Authority.State);
        TimeSpan over = flight.Reactor.Now;
        Assert.True(over - InTheLanes < TimeSpan.FromSeconds(3), $"it took until {over}");

        flight.FlyUntil(f => f.Reactor.Now > over + TimeSpan.FromSeconds(20), TestTimeout);

        Assert.Equal((uint)mode, flight.World.Truth.CustomMode);
        flight.End();
    }

    private SearchFlight Fly(params ScriptedFault[] faults)
        => Fly(new SearchFlight(SearchFlight.SmallPlan(), SearchFlight.SmallWorld(faults)));

    private SearchFlight Fly(SearchFlight flight)
    {
        flight.Fly(TestTimeout);
        output.WriteLine(flight.Log);
        Assert.True(flight.IsOver, $"it hangs in {flight.Mission.Phase}: {flight.Mission.Text}");
        Assert.Empty(flight.Camera.BufferHolders());
        return flight;
    }

    private static void AssertLandedAtHome(SearchFlight flight)
    {
        Assert.Equal(MissionPhase.Done, flight.Mission.Phase);
        Assert.False(flight.World.Truth.IsAirborne);
        Assert.False(flight.World.Truth.IsArmed);
        Assert.True(DistanceFromHome(flight) < 3, $"landed {DistanceFromHome(flight)} m from home");
    }

    private static double DistanceFromHome(SearchFlight flight)
    {
        TruePose pose = flight.World.Truth.Pose;
        return Math.Sqrt((pose.Position.North * pose.Position.North) + (pose.Position.East * pose.Position.East));
    }

    private static ScriptedFault Hang(string manager, double seconds)
        => new()
        {
            Kind = ScriptedFaultKind.ManagerHangs,
            At = InTheLanes,
            Manager = manager,
            Duration = TimeSpan.FromSeconds(seconds)
        };

    private static ScriptedFault Fault(ScriptedFaultKind kind, double value, double seconds = 0)
        => new() { Kind = kind, At = InTheLanes, Value = value, Duration = TimeSpan.FromSeconds(seconds) };
}
