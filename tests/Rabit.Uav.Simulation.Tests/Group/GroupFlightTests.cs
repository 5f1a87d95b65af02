using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation.Tests.Missions;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Group;

/// <summary>Several whole companion computers search one area together, in virtual time, with a radio.</summary>
public sealed class GroupFlightTests(ITestOutputHelper output)
{
    [Fact]
    public void Flight_Two_SearchTheAreaValidateEachOthersTargetsAndKeepApart()
    {
        using GroupFlight flight = Open(2);
        Assert.True(flight.RunToEnd(), flight.Log);
        Assert.All(Vehicles(2), i => Assert.True(
            flight.Mission(i).Result.Outcome == MissionOutcome.Accomplished, flight.Log));
        Assert.Empty(flight.Group.TooNear);
        ValidationTask[] tasks = Validated(flight);
        Assert.True(tasks.Length >= 1, flight.Log);
        Assert.All(tasks, t => Assert.Equal(ValidationResult.Confirmed, t.Result));
        Assert.All(tasks, t => Assert.NotEqual(t.Finder, t.Validator));
    }

    [Fact]
    public void Flight_AtRest_TakesAtMostTwoKilobitsPerSecond()
    {
        using GroupFlight flight = Open(3);
        Assert.False(flight.RunUntil(() => flight.Mission(0).Phase == MissionPhase.Arming, 7), flight.Log);
        long before = flight.Group.RadioOf(0).BytesSent;
        TimeSpan from = flight.Group.Now;
        Assert.False(flight.RunUntil(() => flight.Mission(0).Phase == MissionPhase.Searching, 15), flight.Log);
        double rate = 8 * (flight.Group.RadioOf(0).BytesSent - before) / (flight.Group.Now - from).TotalSeconds;
        Assert.InRange(rate, 800, 2000);
    }

    [Fact, Trait("Category", "Long")]
    public void Flight_SameSeed_IsTheSameToTheByte()
    {
        string[] first = EventLogs(seed: 5);
        Assert.Equal(first, EventLogs(seed: 5));
        Assert.NotEqual(first, EventLogs(seed: 6));
    }

    [Fact]
    public void Flight_OneSystemIdTwice_BothStayOnTheGroundAndAreNamedByAll()
    {
        using GroupFlight flight = Open(
            3, new SimulatedGroupFault(2, SimulatedGroupFaultKind.SameSystemId, TimeSpan.Zero));
        flight.RunUntil(() => flight.Mission(0).Phase == MissionPhase.Searching, 60);

        Assert.Equal(MissionPhase.Searching, flight.Mission(0).Phase);
        Assert.True(flight.LogOf(0).Contains("two vehicles have the system id 2, "), flight.Log);
        Assert.True(Assert.Single(flight.GroupStatus(0).Members).IsTwice);
        Assert.True(flight.GroupStatus(0).Refused > 0);
        foreach (int twin in new[] { 1, 2 })
        {
            Assert.Equal(MissionPhase.WaitingForVehicle, flight.Mission(twin).Phase);
            Assert.Contains("another vehicle has our system id 2", flight.Mission(twin).Text);
            Assert.Contains("have our own address", flight.LogOf(twin));
            Assert.Contains("vehicle 1 is in the group", flight.LogOf(twin));
        }

        Assert.Equal(flight.GroupStatus(0).Lanes, flight.GroupStatus(0).OwnShare.Count);
    }

    [Fact]
    [Trait("Category", "Long")]
    public void Flight_SecondWithOneSystemIdComesLate_FirstSearchesAllAndTheSecondStaysOnTheGround()
    {
        using GroupFlight flight = Open(
            2,
            new SimulatedGroupFault(1, SimulatedGroupFaultKind.SameSystemId, TimeSpan.Zero),
            new SimulatedGroupFault(1, SimulatedGroupFaultKind.SwitchedOn, TimeSpan.FromSeconds(40)));
        Assert.True(flight.RunUntil(() => flight.Mission(0).Phase == MissionPhase.Done, 1800), flight.Log);

        Assert.True(flight.Mission(0).Result.Outcome == MissionOutcome.Accomplished, flight.Log);
        Assert.Contains("have our own address", flight.LogOf(0));
        Assert.Equal(MissionPhase.WaitingForVehicle, flight.Mission(1).Phase);
        Assert.Contains("another vehicle has our system id 1", flight.Mission(1).Text);
        Assert.Empty(flight.Group.TooNear);
    }

    [Fact]
    [Trait("Category", "Long")]
    public void Flight_OneIsLost_TheOtherSearchesTheArea()
    {
        using GroupFlight flight = Open(
            2, new SimulatedGroupFault(1, SimulatedGroupFaultKind.Lost, TimeSpan.FromSeconds(40)));
        Assert.True(flight.RunToEnd(), flight.Log);
        Assert.True(flight.Mission(0).Coverage >= 0.98, flight.Log);
        Assert.Equal(MissionOutcome.Accomplished, flight.Mission(0).Result.Outcome);
        Assert.False(flight.GroupStatus(0).Members.Single().IsPresent);
    }

    [Fact]
    [Trait("Category", "Long")]
    public void Flight_OneIsSwitchedOnLate_TakesAShare()
    {
        using GroupFlight flight = OpenLate(targets: 0);
        Assert.True(flight.RunToEnd(), flight.Log);
        Assert.True(flight.Mission(1).LanesFlown > 0, flight.Log);
        Assert.All(Vehicles(2), i => Assert.True(flight.Mission(i).Coverage >= 0.98, flight.Log));
    }

    // It sees its lanes from above on its way to the targets, and parts of others: what it has seen of those is not
    // known to the first one in detail.
    [Fact]
    public void Flight_LateOneSeesItsShareWhileItValidates_BothKnowThatAllIsSeen()
    {
        using GroupFlight flight = OpenLate(targets: 2);
        Assert.True(flight.RunToEnd(), flight.Log);
        Assert.Equal(2, Validated(flight).Length);
        Assert.All(Vehicles(2), i => Assert.True(flight.Mission(i).Coverage >= 0.98, flight.Log));
        Assert.All(Vehicles(2), i => Assert.Equal(MissionOutcome.Accomplished, flight.Mission(i).Result.Outcome));
    }

    [Fact]
    [Trait("Category", "Long")]
    public void Flight_RadioOfOneIsDead_BothSearchAllAndKeepApart()
    {
        using GroupFlight flight = Open(
            2, new SimulatedGroupFault(0, SimulatedGroupFaultKind.RadioDead, TimeSpan.FromSeconds(8)));
        Assert.True(flight.RunToEnd(), flight.Log);
        Assert.All(Vehicles(2), i => Assert.True(flight.Mission(i).Coverage >= 0.98, flight.Log));
        Assert.Empty(flight.Group.TooNear);
    }

    [Fact]
    [Trait("Category", "Long")]
    public void Flight_CameraOfOneIsDead_ReturnsAndTheOtherSeesTheArea()
    {
        var dead = new ScriptedFault
        {
            Kind = ScriptedFaultKind.CameraFreeze,
            At = TimeSpan.FromSeconds(40),
            Duration = TimeSpan.FromHours(1),
        };
        SimulationOptions world = SearchFlight.SmallWorld();
        using GroupFlight flight = Open(
            2, world, vehicleFaults: new Dictionary<int, IReadOnlyList<ScriptedFault>> { [1] = [dead] });
        Assert.True(flight.RunToEnd(), flight.Log);
        Assert.True(flight.Mission(0).Coverage >= 0.98, flight.Log);
        Assert.True(flight.Mission(0).Result.Outcome == MissionOutcome.Accomplished, flight.Log);
        Assert.NotEqual(MissionOutcome.Accomplished, flight.Mission(1).Result.Outcome);
        Assert.Contains("camera", flight.LogOf(1));
        Assert.Empty(flight.Group.TooNear);
    }

    // Of each in its own way: the autopilots hold what their barometers say, the goals follow the satellite receivers.
    [Theory]
    [Trait("Category", "Long")]
    [InlineData(5)]
    [InlineData(6)]
    [InlineData(8)]
    [InlineData(10)]
    public void Flight_BarometersDrift_TrueHeightsStayThoseOfTheLayers(long seed)
    {
        SimulationOptions world = SearchFlight.SmallWorld();
        (world.Seed, world.BarometerDriftMetres) = (seed, 5);
        using GroupFlight flight = Open(2, world, speed: 1.5);   // long enough for a barometer to drift
        (double reported, double real) = (0, 0);
        bool hasEnded = flight.RunUntil(
            () =>
            {
                foreach (int i in Vehicles(2).Where(i => flight.Mission(i).Phase == MissionPhase.Searching))
                {
                    double height = -flight.Group.Vehicles[i].World.Truth.Pose.Position.Down;
                    real = Math.Max(real, Math.Abs(height - LayerHeight(i)));
                    reported = Math.Max(reported, Math.Abs(flight.Vehicle(i).HeightAboveHomeMetres - LayerHeight(i)));
                }

                return Vehicles(2).All(i => flight.Mission(i).Phase is MissionPhase.Done or MissionPhase.Failed);
            },
            1800);
        Assert.True(hasEnded, flight.Log);
        output.WriteLine(FormattableString.Invariant(
            $"seed {seed}: off the layers by {reported:0.0} m as reported, {real:0.0} m in truth"));
        Assert.True(reported > 3, $"{reported} m reported");
        Assert.InRange(real, 0, 3);
        Assert.Empty(flight.Group.TooNear);
    }

    private static double LayerHeight(int vehicle) => 18 + (19 * vehicle);

    // One mission, flown by each alone, from places beside each other.
    [Fact]
    public void TooNear_TwoThatFlyOneMissionWithoutAGroup_AreNamed()
    {
        SimulationOptions world = SearchFlight.SmallWorld();
        world.TargetCount = 0;
        using GroupFlight flight = Open(2, world, isGroup: false);
        Assert.True(flight.RunUntil(() => flight.Group.TooNear.Count > 0, 120), flight.Log);
        Separation near = Assert.Single(flight.Group.TooNear);
        Assert.Equal((0, 1), (near.First, near.Second));
        Assert.InRange(near.HorizontalMetres, 0, 30);
        Assert.InRange(near.VerticalMetres, 0, 15);
        Assert.InRange(near.Time, TimeSpan.FromSeconds(5), flight.Group.Now);
    }

    // A second one on the way of the first, beside it.
    [Theory]
    [InlineData(0.5, 1)]
    [InlineData(2, 0)]
    public void Collisions_TwoBesideEachOther_AreThoseThatMeet(double metresApart, int expected)
    {
        using GroupFlight flight = Open(1);
        SimulatedGroupVehicle first = flight.Group.Vehicles[0];
        var second = new SimulatedGroupVehicle(first.World, first.Time, first.Radio, TimeSpan.Zero)
        {
            Start = first.Start + new NedVector(0, metresApart, 0),
        };
        var watch = new SeparationWatch();
        bool areNear = flight.RunUntil(
            () =>
            {
                watch.Update([first, second], flight.Group.Now);
                return watch.TooNear.Count > 0;
            },
            120);
        Assert.True(areNear, flight.Log);
        Assert.Equal(metresApart, watch.TooNear[0].HorizontalMetres, 3);
        Assert.Equal(expected, watch.Collisions.Count);
    }

    private static string[] EventLogs(long seed)
    {
        using GroupFlight flight = Open(2, seed, hasEventLogs: true);
        flight.RunUntil(() => false, 45);
        return flight.EventLogs.Select(l => l.ToString()).ToArray();
    }

    private static ValidationTask[] Validated(GroupFlight flight) => Vehicles(2)
        .SelectMany(i => flight.GroupStatus(i).Validations.Where(t => t.Finder == i + 1))
        .Where(t => t.Validator != 0).ToArray();

    private static IEnumerable<int> Vehicles(int count) => Enumerable.Range(0, count);

    private static GroupFlight Open(int vehicles, params SimulatedGroupFault[] faults)
        => Open(vehicles, seed: 5, hasEventLogs: false, faults);

    private static GroupFlight OpenLate(int targets)
    {
        SimulationOptions world = SearchFlight.SmallWorld();
        (world.Seed, world.TargetCount) = (5, targets);
        return Open(
            2, world,
            faults: new SimulatedGroupFault(1, SimulatedGroupFaultKind.SwitchedOn, TimeSpan.FromSeconds(20)));
    }

    private static GroupFlight Open(
        int vehicles, long seed, bool hasEventLogs, params SimulatedGroupFault[] faults)
    {
        SimulationOptions world = SearchFlight.SmallWorld();
        world.Seed = seed;
        return Open(vehicles, world, hasEventLogs, faults: faults);
    }

    // Low, so that the small pictures show what lies there.
    private static GroupFlight Open(
        int vehicles, SimulationOptions world, bool hasEventLogs = false, bool isGroup = true, double speed = 5,
        IReadOnlyDictionary<int, IReadOnlyList<ScriptedFault>>? vehicleFaults = null,
        params SimulatedGroupFault[] faults)
    {
        MissionPlan plan = MissionPlan.Parse(
            SearchFlight.SmallMission.Replace("\"heightMetres\": 30", "\"heightMetres\": 18")
                .Replace("\"laneSpacingMetres\": 22", "\"laneSpacingMetres\": 14")
                .Replace(
                    "\"speedMetresPerSecond\": 5", FormattableString.Invariant($"\"speedMetresPerSecond\": {speed}")),
            "small");
        return new GroupFlight(
            plan,
            new SimulatedGroupOptions
            {
                Vehicles = vehicles,
                World = world,
                Faults = faults,
                VehicleFaults = vehicleFaults ?? new Dictionary<int, IReadOnlyList<ScriptedFault>>(),
            },
            layerSpacingMetres: 19, hasEventLogs, isGroup: isGroup);
    }
}
