using System;
using System.Collections.Generic;
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

    // What names a vehicle or a station that is not there would have no effect.
    [Fact]
    public void Options_FaultsAndPartitionsOfWhatIsNotThere_AreNamed()
    {
        var options = new SimulatedGroupOptions
        {
            Vehicles = 2,
            Faults = [null!, new SimulatedGroupFault(0, (SimulatedGroupFaultKind)9, TimeSpan.Zero)],
            VehicleFaults = new Dictionary<int, IReadOnlyList<ScriptedFault>> { [0] = null!, [2] = [], [-1] = [] },
            GroundStations = [new SimulatedStationPlace(0, 0)],
            Radio = new SimulatedRadioOptions
            {
                Partitions =
                [
                    null!,
                    new RadioPartition(TimeSpan.Zero, TimeSpan.FromSeconds(1), null!),
                    new RadioPartition(TimeSpan.FromSeconds(-1), TimeSpan.FromSeconds(1), [0]),
                    new RadioPartition(TimeSpan.Zero, TimeSpan.Zero, [0]),
                    new RadioPartition(TimeSpan.Zero, TimeSpan.FromSeconds(1), [2, 3]),
                ],
            },
        };

        string message = Assert.Throws<ArgumentException>(() => new SimulatedGroup(options)).Message;

        Assert.Contains("Faults has one that is null", message);
        Assert.Contains("Faults has one of kind 9, which there is not", message);
        Assert.Contains("VehicleFaults has null for vehicle 0", message);
        Assert.Contains("VehicleFaults has some of vehicle 2; they are numbered from 0 to 1", message);
        Assert.Contains("VehicleFaults has some of vehicle -1; they are numbered from 0 to 1", message);
        Assert.Contains("Radio: Partitions has one that is null, or has no stations", message);
        Assert.Contains("Radio: Partitions has one at -00:00:01 for 00:00:01; both", message);
        Assert.Contains("Radio: Partitions has one at 00:00:00 for 00:00:00; both", message);
        Assert.Contains(
            "Radio: Partitions has one with station 3; vehicles and ground stations are numbered from 0 to 2", message);
        Assert.DoesNotContain("station 2;", message);
    }

    private static double Metres(GeodeticPosition a, GeodeticPosition b)
        => NedPosition.Origin.HorizontalDistanceTo(LocalNedFrame.IgnoringGeoid(a).ToNed(b));
}
