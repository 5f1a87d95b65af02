using System;
using System.Linq;
using Rabit.Geodesy;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Group;

/// <summary>Where the vehicles of a simulated group stand.</summary>
public sealed class SimulatedGroupTests
{
    // At least 10 m are needed by what satellites say, which is off by some metres, and a mission is flown from within
    // 50 m of where its file says.
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(5)]
    [InlineData(6)]
    [InlineData(7)]
    [InlineData(SimulatedGroupOptions.MaxVehicles)]
    public void Vehicles_AnyCount_StandFarEnoughApartAndNearHome(int count)
    {
        var group = new SimulatedGroup(new SimulatedGroupOptions { Vehicles = count });
        GeodeticPosition[] places = group.Vehicles.Select(v => v.World.PositionOf(NedPosition.Origin)).ToArray();

        foreach ((GeodeticPosition place, int i) in places.Select((p, i) => (p, i)))
        {
            Assert.InRange(Metres(places[0], place), 0, 45);
            Assert.All(places.Skip(i + 1), other => Assert.InRange(Metres(place, other), 19.9, 100));
            Assert.Equal(
                Metres(places[0], place),
                group.Vehicles[0].Start.HorizontalDistanceTo(group.Vehicles[i].Start), tolerance: 0.01);
        }
    }

    private static double Metres(GeodeticPosition a, GeodeticPosition b)
        => NedPosition.Origin.HorizontalDistanceTo(LocalNedFrame.IgnoringGeoid(a).ToNed(b));
}
