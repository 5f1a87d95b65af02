using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Links;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Stations;

/// <summary>Several ground stations at once that reach the autopilot through the computer on board.</summary>
public class HubTests(ITestOutputHelper output)
{
    private static readonly string[] Done =
    [
        "set Done",
        "Mission up Done", "Mission down Done the same", "Fence up Done", "Fence down Done the same",
        "Rally up Done", "Rally down Done the same", "file Done", "ping",
    ];

    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void ThreeStations_ParametersMissionsAndFilesAtOnce_AllAreServedThroughUs(SimulatedAutopilot autopilot)
    {
        var world = new SimulatedWorld(new SimulationOptions { Autopilot = autopilot, Seed = 3 });
        output.WriteLine("seed 3");
        var vehicle = new MemoryLinkPair("vehicle");
        MemoryLinkPair[] links =
            [new MemoryLinkPair("station 255"), new MemoryLinkPair("station 254"), new MemoryLinkPair("station 253")];
        using UavSystem uav = UavSystem.Open(new UavOptions
        {
            OpenLinks = [vehicle.A, .. links.Select(l => l.A)],
            Time = new VirtualTime(3),
        });
        var log = new List<RabitLogEntry>();
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions { StopsOnSignals = false, Log = log.Add });
        reactor.Add(world.CreateVehicle(vehicle.B));
        StationClient[] stations =
            links.Select((link, i) => new StationClient((byte)(255 - i), autopilot, link.B)).ToArray();
        foreach (StationClient station in stations)
            reactor.Add(station);
        reactor.Start();
        for (int second = 0; second < 300 && !stations.All(s => s.IsDone); second++)
            Assert.True(reactor.RunFor(TimeSpan.FromSeconds(1)), string.Join("\n", log));
        TimeSpan end = reactor.Now;
        reactor.Stop("the test is over");
        Assert.Equal(0, reactor.Finish().ExitCode);

        output.WriteLine($"{autopilot}: {end.TotalSeconds:0} s");
        foreach (StationClient station in stations)
        {
            output.WriteLine(string.Join("; ", station.Results));
            Assert.StartsWith("parameters Done ", station.Results[0], StringComparison.Ordinal);
            Assert.Equal(Done, station.Results.Skip(1));
        }

        Assert.All(stations, s => Assert.Equal(stations[0].Results[0], s.Results[0]));
        if (autopilot == SimulatedAutopilot.ArduPilot)
            Assert.All(stations, s => Assert.Equal(0x671B, BitConverter.ToUInt16(s.File, 0)));
    }
}
