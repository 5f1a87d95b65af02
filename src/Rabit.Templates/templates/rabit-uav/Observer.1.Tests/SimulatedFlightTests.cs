using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation;
using Xunit;

namespace Observer._1.Tests;

/// <summary>
/// The manager and the detector in a whole flight: the six managers search a simulated meadow with one orange panel, in
/// virtual time. The same seed gives the same flight.
/// </summary>
public sealed class SimulatedFlightTests
{
    private const string Meadow =
        """
        {
          "name": "meadow", "targets": ["raft"],
          "area": [[47.39730, 8.54470], [47.39780, 8.54470], [47.39780, 8.54560], [47.39730, 8.54560]],
          "heightMetres": 30, "speedMetresPerSecond": 5, "laneSpacingMetres": 22
        }
        """;

    [Fact]
    public void Flight_OverAnOrangePanel_ReportsARaft()
    {
        MissionPlan mission = MissionPlan.Parse(Meadow, "meadow");
        var worldOptions = new SimulationOptions { Seed = 4, TargetCount = 1, DistractorCount = 0 };
        worldOptions.TakePlacesFrom(mission);
        var world = new SimulatedWorld(worldOptions);
        var telemetry = new MemoryLinkPair("telemetry");
        var lines = new List<string>();

        using UavSystem uav = UavSystem.Open(new UavOptions
        {
            OpenLinks = [telemetry.A],
            OtherManagers = [world.CreateVehicle(telemetry.B), new Watcher(lines.Add)],
            Mission = mission,
            MayCommand = true,   // the simulated vehicle: here someone has to fly
            Camera = world.CreateCamera(),
            Imaging = new ImageProcessingOptions
            {
                Camera = world.CameraModel,
                Mount = world.CameraMount,
                TargetClasses = [RaftDetector.Raft],
                Detector = new RaftDetector(),
            },
            Time = new VirtualTime(worldOptions.Seed),
        });
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions());
        reactor.Start();
        while (reactor.Now < TimeSpan.FromMinutes(3) && !lines.Exists(IsRaft))
            Assert.True(reactor.RunFor(TimeSpan.FromSeconds(5)));
        reactor.Stop();

        Assert.Equal(0, reactor.Finish().ExitCode);
        Assert.Single(lines, line => IsRaft(line));
    }

    private static bool IsRaft(string line) => line.Contains(": raft at ", StringComparison.Ordinal);
}
