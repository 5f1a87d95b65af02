using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>
/// Whole missions over a terrain grid with both simulated autopilots. The world's own ground is level: what counts is
/// how far above the grid the vehicle flies.
/// </summary>
public sealed class TerrainFlightTests(ITestOutputHelper output)
{
    private const double HeightMetres = 30;

    private readonly StringBuilder _log = new();

    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void Mission_OverARidge_KeepsItsHeightAboveGroundAndReturnsAboveIt(SimulatedAutopilot autopilot)
    {
        var heights = new List<double>();
        double highest = 0;
        double leastOnReturn = double.PositiveInfinity;
        MissionStatus status = Fly(autopilot, heightOfTheRidge: 14, TimeSpan.FromMinutes(15), (phase, at) =>
        {
            double above = -at.Down - Ridge(14, at.North);
            if (phase is MissionPhase.Searching or MissionPhase.InTransit)
            {
                heights.Add(above);
                highest = Math.Max(highest, -at.Down);
            }
            else if (phase == MissionPhase.Returning)
                leastOnReturn = Math.Min(leastOnReturn, above);
        });

        output.WriteLine(
            $"{heights.Min():0.0} to {heights.Max():0.0} m above ground, up to {highest:0.0} m above home, "
                + $"{leastOnReturn:0.0} m above ground on the way home");
        Assert.Equal((MissionPhase.Done, MissionOutcome.Accomplished), (status.Phase, status.Result.Outcome));
        Assert.InRange(heights.Min(), HeightMetres - 2.5, HeightMetres + 2.5);
        Assert.InRange(heights.Max(), HeightMetres, HeightMetres + 12);
        Assert.InRange(highest, HeightMetres + 9, HeightMetres + 20);
        Assert.InRange(leastOnReturn, 10, 60);
        Assert.DoesNotContain("no progress", _log.ToString(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void Mission_ReturnHeightBelowTheTerrain_IsRefusedByTheChecklist(SimulatedAutopilot autopilot)
    {
        MissionStatus status = Fly(autopilot, heightOfTheRidge: 25, TimeSpan.FromMinutes(1), (_, _) => { });
        Assert.Equal(MissionPhase.WaitingForVehicle, status.Phase);
        Assert.Contains("fail return-height: 30 m", _log.ToString(), StringComparison.Ordinal);
    }

    private MissionStatus Fly(
        SimulatedAutopilot autopilot, double heightOfTheRidge, TimeSpan limit,
        Action<MissionPhase, NedPosition> look)
    {
        bool isPx4 = autopilot == SimulatedAutopilot.Px4;
        SimulationOptions simulation = SearchFlight.SmallWorld();
        simulation.Autopilot = autopilot;
        simulation.Parameters = new Dictionary<string, double>(StringComparer.Ordinal)
        {
            [isPx4 ? "RTL_RETURN_ALT" : "RTL_ALT"] = isPx4 ? 30 : 3000,
        };
        var options = new UavOptions
        {
            Mission = SearchFlight.SmallPlan(),
            MayCommand = true,
            Time = new VirtualTime(simulation.Seed),
            Terrain = TestTerrain.Around(
                GeodeticPosition.FromDegrees(47.3971, 8.5445, 488), (n, _) => Ridge(heightOfTheRidge, n),
                postMetres: 5, halfMetres: 400),
        };
        (options.MissionControl.RequiresCamera, options.MissionControl.CoverageGoal) = (false, 0);
        simulation.TakePlacesFrom(options.Mission);
        var world = new SimulatedWorld(simulation);
        var link = new MemoryLinkPair("simulation");
        options.OpenLinks = [link.A];
        using UavSystem uav = UavSystem.Open(options);
        RabitReactor reactor = uav.CreateReactor(
            new ReactorOptions { StopsOnSignals = false, Log = e => _log.AppendLine(e.ToString()) });
        reactor.Add(world.CreateVehicle(link.B));
        MessageSubscriber<MissionStatus> mission = reactor.Workspace.Subscribe<MissionStatus>(MessageNames.Mission);
        reactor.Start();
        while (reactor.Now < limit && mission.Value.Phase is not (MissionPhase.Done or MissionPhase.Failed))
        {
            reactor.RunFor(TimeSpan.FromSeconds(0.2));
            mission.Fetch();
            look(mission.Value.Phase, world.Truth.Pose.Position);
        }

        reactor.Stop("the test is over");
        reactor.Finish();
        return mission.Value;
    }

    // Across the lanes' area, 22 to 78 m north of home.
    private static double Ridge(double height, double north)
        => height * Math.Exp(-((north - 50) * (north - 50)) / (2 * 20 * 20));
}
