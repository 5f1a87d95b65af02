using System;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation.Tests.Missions;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Group;

/// <summary>A ground station commands one vehicle of a group, or all, by radio, in flight.</summary>
public sealed class GroupCommandTests
{
    [Fact]
    public void Hold_OfOne_OthersTakeItsLanesAndContinueGivesItSomeAgain()
    {
        using GroupFlight flight = Open();
        SimulatedGroundStation station = flight.Group.GroundStations[0];
        Assert.True(flight.RunUntil(() => flight.Mission(1).Phase == MissionPhase.Searching, 90), flight.Log);

        StationCommand hold = station.Command(2, OperatorCommand.Hold);
        Assert.True(flight.RunUntil(() => hold.IsDone, 5), flight.Log);
        Assert.Equal("accepted by 2", hold.Answer);
        Assert.True(
            flight.RunUntil(() => flight.GroupStatus(0).OwnShare.Count == flight.GroupStatus(0).Lanes, 5), flight.Log);
        Assert.Equal(MissionPhase.Holding, flight.Mission(1).Phase);
        Assert.True(flight.Mission(0).Phase is MissionPhase.Searching or MissionPhase.InTransit);

        StationCommand go = station.Command(0, OperatorCommand.Continue);
        Assert.True(flight.RunUntil(() => go.IsDone, 5), flight.Log);

        // The first one was not interrupted.
        Assert.Equal("accepted by 2; refused by 1", go.Answer);
        Assert.True(flight.RunUntil(() => flight.GroupStatus(1).OwnShare.Count > 0, 6), flight.Log);
        Assert.Contains("operator system 255 component 190's hold accepted", flight.LogOf(1));
    }

    [Fact]
    [Trait("Category", "Long")]
    public void Return_OfOne_OthersSearchAllThatIsLeft()
    {
        using GroupFlight flight = Open();
        SimulatedGroundStation station = flight.Group.GroundStations[0];
        Assert.True(flight.RunUntil(() => flight.Mission(1).Phase == MissionPhase.Searching, 90), flight.Log);
        StationCommand home = station.Command(2, OperatorCommand.Return);

        Assert.True(flight.RunToEnd(), flight.Log);
        Assert.Equal("accepted by 2", home.Answer);
        Assert.Equal(MissionOutcome.Accomplished, flight.Mission(0).Result.Outcome);
        Assert.True(flight.Mission(0).Coverage >= 0.98, flight.Log);
        Assert.NotEqual(MissionOutcome.Accomplished, flight.Mission(1).Result.Outcome);
        Assert.Empty(flight.Group.TooNear);
    }

    [Fact]
    [Trait("Category", "Long")]
    public void Return_OfAllInAPartition_BringsHomeWhoReceivesItAndTheOtherSearchesOn()
    {
        using GroupFlight flight = Open(new RadioPartition(TimeSpan.FromSeconds(40), TimeSpan.FromSeconds(30), [1]));
        SimulatedGroundStation station = flight.Group.GroundStations[1];
        flight.RunUntil(() => flight.Group.Now >= TimeSpan.FromSeconds(45), 50);
        StationCommand home = station.Command(0, OperatorCommand.Return);

        Assert.True(flight.RunUntil(() => home.IsDone, 15), flight.Log);
        Assert.Equal("accepted by 1; no answer of 2", home.Answer);
        Assert.True(flight.RunToEnd(), flight.Log);
        Assert.Contains("operator system 254 component 190's return accepted", flight.LogOf(0));
        Assert.True(flight.Mission(1).Result.Outcome == MissionOutcome.Accomplished, flight.Log);
        Assert.True(flight.Mission(1).Coverage >= 0.98, flight.Log);
        Assert.Empty(flight.Group.TooNear);
    }

    private static GroupFlight Open(params RadioPartition[] partitions)
    {
        SimulationOptions world = SearchFlight.SmallWorld();
        world.Seed = 5;
        MissionPlan plan = MissionPlan.Parse(
            SearchFlight.SmallMission.Replace("\"heightMetres\": 30", "\"heightMetres\": 18")
                .Replace(
                    "\"laneSpacingMetres\": 22",
                    "\"groundStationLost\": {\"action\": \"continue\"}, \"laneSpacingMetres\": 14"),
            "small");
        var options = new SimulatedGroupOptions
        {
            Vehicles = 2,
            World = world,
            Radio = new SimulatedRadioOptions { Partitions = partitions.ToArray() },
            GroundStations = [new SimulatedStationPlace(-20, 0), new SimulatedStationPlace(0, -300)],
        };
        return new GroupFlight(plan, options, layerSpacingMetres: 19);
    }
}
