using System;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation.Tests.Missions;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Group;

/// <summary>Several whole companion computers search one area together, in virtual time.</summary>
public sealed class GroupFlightTests(ITestOutputHelper output)
{
    [Fact]
    public void Flight_Three_SearchTheAreaAndKeepApart()
    {
        using var flight = new GroupFlight(SearchFlight.BundledPlan(), Options());
        System.Diagnostics.Stopwatch w = System.Diagnostics.Stopwatch.StartNew();
        Assert.True(flight.RunToEnd(), flight.Log);
        output.WriteLine($"{flight.Group.Now.TotalSeconds} s in {w.Elapsed.TotalSeconds}");
        for (int i = 0; i < 3; i++)
        {
            var r = flight.Group.RadioOf(i);
            output.WriteLine($"{i}: {r.FramesSent} frames {r.BytesSent / flight.Group.Now.TotalSeconds * 8} bit/s delivered {r.Delivered} lost {r.LostAtRandom} {flight.Mission(i).Result.Outcome} {flight.Mission(i).Coverage}");
        }

        output.WriteLine(flight.Log);
        Assert.Empty(flight.Group.TooNear);
        Assert.All(Enumerable.Range(0, 3), i => Assert.Equal(MissionOutcome.Accomplished, flight.Mission(i).Result.Outcome));
    }

    private static SimulatedGroupOptions Options() => new() { World = { Seed = 5, TargetCount = 5 } };
}
