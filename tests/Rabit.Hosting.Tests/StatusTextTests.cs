using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.DependencyInjection;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav;
using Rabit.Uav.Hosting;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation;
using Xunit;

namespace Rabit.Hosting.Tests;

/// <summary>What "systemctl status" shows of a flight: phase, health, and what is wrong with managers.</summary>
public sealed class StatusTextTests
{
    private const string SmallMission =
        """
        {
          "name": "small meadow",
          "area": [[47.39730, 8.54470], [47.39760, 8.54470], [47.39760, 8.54520], [47.39730, 8.54520]],
          "heightMetres": 30, "speedMetresPerSecond": 8, "laneSpacingMetres": 30
        }
        """;

    [Fact]
    public async Task Status_OfAFlight_HasPhaseHealthAndManagers()
    {
        List<string> lines = await FlyAsync(new SimulationOptions { Seed = 3, TargetCount = 0 });

        Assert.Equal("phase WaitingForVehicle, health Good; 8 managers run", lines.First(l => l.Contains("Good")));
        string[] phases = lines.Select(l => l.Split([' ', ','])[1]).ToArray();
        Assert.Equal(
            ["WaitingForVehicle", "Arming", "TakingOff", "InTransit", "Searching", "Returning", "Landing", "Done"],
            phases.Where((p, i) => i == 0 || p != phases[i - 1]));
        Assert.Contains("phase Searching, health Good; 8 managers run", lines);
        Assert.All(lines, l => Assert.EndsWith("; 8 managers run", l));
    }

    [Fact]
    public async Task Status_BatteryLow_SaysWhyHealthIsNotGood()
    {
        List<string> lines = await FlyAsync(
            new SimulationOptions { Seed = 3, TargetCount = 0, BatteryRemaining = 0.12 });

        Assert.Contains(lines, l => l.Contains("health ") && l.Contains("Battery"));
    }

    // One line for each change.
    private static async Task<List<string>> FlyAsync(SimulationOptions world)
    {
        var lines = new List<string>();
        using var host = new TestHost(s =>
        {
            s.AddRabitUav(new ConfigurationBuilder().Build(), uav => uav
                .Configure((_, o) => Simulate(world, o))
                .AddManager(p => new StatusReader(
                    new ReactorWatch(p.GetRequiredService<HostedReactors>(), "rabit"), lines)));
        });
        await host.StartAsync();
        await host.WaitForReactorAsync();
        await host.StopAsync();
        Assert.Equal(0, host.ExitCode);
        return lines;
    }

    private static void Simulate(SimulationOptions worldOptions, UavOptions options)
    {
        options.Mission = MissionPlan.Parse(SmallMission, "test");
        worldOptions.TakePlacesFrom(options.Mission);
        var world = new SimulatedWorld(worldOptions);
        var telemetry = new MemoryLinkPair("telemetry");
        options.OpenLinks = [telemetry.A];
        options.OtherManagers = [world.CreateVehicle(telemetry.B)];
        options.MayCommand = true;
        options.MissionControl.RequiresCamera = false;   // pictures take most of the time
        options.Time = new VirtualTime(worldOptions.Seed);
    }

    /// <summary>Reads the status as the notifier does, but in virtual time, until the mission has ended.</summary>
    private sealed class StatusReader : RabitManager
    {
        private static readonly TimeSpan Limit = TimeSpan.FromMinutes(15);

        private readonly ReactorWatch _watch;
        private readonly List<string> _lines;

        public StatusReader(ReactorWatch watch, List<string> lines)
            : base("status reader")
        {
            (_watch, _lines) = (watch, lines);
            Period = TimeSpan.FromSeconds(0.2);
        }

        protected override void ExecuteUnitOfWork()
        {
            string line = _watch.Look().StatusLine;
            if (Now > TimeSpan.Zero && line != _lines.LastOrDefault())
                _lines.Add(line);
            if (line.StartsWith("phase Done", StringComparison.Ordinal)
                || line.StartsWith("phase Failed", StringComparison.Ordinal) || Now > Limit)
                StopSystem("it has been seen");
        }
    }
}
