using System;
using System.IO;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;
using Xunit;

namespace UavConsole.Tests;

/// <summary>What is said at the end of the flight of a group.</summary>
public sealed class GroupSummaryTextTests
{
    [Fact]
    public void Write_NothingFoundAndOneLane_HasNeitherNaNNorOneLanes()
    {
        string text = TextOf(new MissionStatus { LanesFlown = 1 });

        Assert.DoesNotContain("NaN", text);
        Assert.Contains("0 of 0 targets found, 0 false" + Environment.NewLine, text);
        Assert.Contains("vehicle 1: no mission, 1 lane flown, ", text);
    }

    [Fact]
    public void Write_TargetOfAClassThatMoves_SaysHowItWasFollowed()
    {
        var task = new FollowTask
        {
            Finder = 1,
            Class = DefaultTargetClasses.Red,
            Follower = 2,
            State = FollowState.Closed,
            Result = FollowResult.Followed,
            InView = TimeSpan.FromSeconds(31),
        };

        Assert.Contains(
            "red, of a class that moves: found by vehicle 1, followed: by vehicle 2, 31 s in view",
            TextOf(default, task));
    }

    private static string TextOf(MissionStatus mission, params FollowTask[] followings)
    {
        var record = new FlightRecord { Mission = mission, Group = new GroupStatus { Followings = [.. followings] } };
        var flight = new FlightSummary(record) { Mission = new MissionSummary(record, score: null) };
        var group = new GroupFlightSummary([new GroupVehicleSummary(1, flight) { Radio = new RadioUse() }])
        {
            Score = new MissionScore(),
        };
        using var output = new StringWriter();
        GroupSummaryText.Write(output, group);
        return output.ToString();
    }
}
