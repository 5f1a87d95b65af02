using System;
using Rabit.Core;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>Takeovers, the operator's commands and the stop of the program, with all managers.</summary>
public sealed class OperatorTests(ITestOutputHelper output)
{
    private static readonly TimeSpan InTheLanes = TimeSpan.FromSeconds(50);
    private static readonly TimeSpan TestTimeout = TimeSpan.FromMinutes(10);

    [Fact]
    public void Resume_AfterThePilotsLoiter_FinishesTheMission()
    {
        using var flight = new SearchFlight(
            SearchFlight.SmallPlan(),
            SearchFlight.SmallWorld(new ScriptedFault
            {
                Kind = ScriptedFaultKind.PilotMode,
                At = InTheLanes,
                Value = 5,
            }));
        flight.FlyUntil(f => f.Mission.Phase == MissionPhase.HandedOver, TestTimeout);
        TimeSpan over = flight.Reactor.Now;
        flight.FlyUntil(f => f.Reactor.Now > over + TimeSpan.FromSeconds(10), TestTimeout);
        Assert.Equal(5u, flight.World.Truth.CustomMode);
        flight.Control.ContinueMission("test", "the pilot gives it back");
        flight.FlyUntil(f => f.Mission.Phase != MissionPhase.HandedOver, TestTimeout);
        flight.FlyUntil(f => f.IsOver, TestTimeout);
        flight.End();
        output.WriteLine(flight.Log);

        MissionStatus end = flight.Mission;
        Assert.Equal((MissionPhase.Done, MissionOutcome.Accomplished), (end.Phase, end.Result.Outcome));
        Assert.Equal("the pilot took over: mode LOITER", end.TakenOver);
        Assert.True(end.Coverage >= 0.98, $"{end.Coverage} seen");
    }

    [Fact]
    public void Hold_InALaneAndResume_FinishesTheMission()
    {
        using var flight = new SearchFlight(SearchFlight.SmallPlan(), SearchFlight.SmallWorld());
        flight.FlyUntil(f => f.Reactor.Now > InTheLanes, TestTimeout);
        flight.Control.Hold("test", "test");
        flight.FlyUntil(f => f.Reactor.Now > InTheLanes + TimeSpan.FromSeconds(30), TestTimeout);
        Assert.Equal(MissionPhase.Holding, flight.Mission.Phase);
        Assert.True(SpeedOf(flight) < 1, $"{SpeedOf(flight)} m/s in the hold");
        flight.Control.ContinueMission("test", "test");
        flight.FlyUntil(f => f.IsOver, TestTimeout);
        flight.End();
        output.WriteLine(flight.Log);
        Assert.Equal(MissionOutcome.Accomplished, flight.Mission.Result.Outcome);
    }

    [Theory]
    [InlineData(OnStop.Hold, MissionStopResult.Held)]
    [InlineData(OnStop.Return, MissionStopResult.Returning)]
    public void Stop_InALane_TheVehicleHoldsOrReturnsBeforeTheProgramEnds(OnStop onStop, MissionStopResult result)
    {
        using var flight = new SearchFlight(
            SearchFlight.SmallPlan(), SearchFlight.SmallWorld(), new VirtualTime(5), [], onStop: onStop);
        flight.FlyUntil(f => f.Reactor.Now > InTheLanes, TestTimeout);
        TimeSpan from = flight.Reactor.Now;
        flight.End();
        output.WriteLine(flight.Log);

        Assert.Equal(result, flight.Mission.StopResult);
        Assert.InRange(flight.Reactor.Now - from, TimeSpan.Zero, TimeSpan.FromSeconds(3));
    }

    [Theory]
    [InlineData(1, SimulatedAutopilot.ArduPilot)]
    [InlineData(2, SimulatedAutopilot.Px4)]
    public void LegProgress_NominalFlightInWind_IsNoFalseAlarm(long seed, SimulatedAutopilot model)
        => FlyInWind(seed, model, metresPerSecond: 8);

    [Theory, Trait("Category", "Long")]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void LegProgress_FortySeedsInWindToEight_IsNoFalseAlarm(SimulatedAutopilot model)
    {
        for (long seed = 1; seed <= 40; seed++)
            FlyInWind(seed, model, metresPerSecond: seed % 9);
    }

    private static double SpeedOf(SearchFlight flight)
    {
        (double n, double e) = (flight.World.Truth.Pose.VelocityNed.North, flight.World.Truth.Pose.VelocityNed.East);
        return Math.Sqrt((n * n) + (e * e));
    }

    // Neither a leg without progress nor another commander.
    private void FlyInWind(long seed, SimulatedAutopilot model, double metresPerSecond)
    {
        SimulationOptions world = SearchFlight.SmallWorld();
        (world.Seed, world.Autopilot, world.WindMetresPerSecond) = (seed, model, metresPerSecond);
        using var flight = new SearchFlight(SearchFlight.SmallPlan(), world);
        flight.Fly(TestTimeout);
        output.WriteLine($"seed {seed}, wind {metresPerSecond} m/s\n" + flight.Log);
        Assert.DoesNotContain("no progress", flight.Log, StringComparison.Ordinal);
        Assert.True(flight.Mission is { Phase: MissionPhase.Done, Aborted: null }, $"seed {seed}: {flight.Mission.Text}");
    }
}
