using System;
using System.IO;
using Rabit.Geodesy;
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

    [Fact]
    public void Write_TargetOfAClassThatMovesWasNotFollowed_SaysSo()
    {
        TargetTrack walking = Track(7, TrackState.Confirmed, TargetMotion.Walking);
        TargetTrack standing = Track(8, TrackState.Confirmed, TargetMotion.Standing);
        TargetTrack tentative = Track(9, TrackState.Tentative, TargetMotion.Walking);

        string text = TextOf(default, new TrackList(TimeSpan.Zero, [walking, standing, tentative]));

        Assert.Contains("red at 47.397700 8.545600, of a class that moves: NOT FOLLOWED", text);
        Assert.Equal(
            text.IndexOf("NOT FOLLOWED", StringComparison.Ordinal),
            text.LastIndexOf("NOT FOLLOWED", StringComparison.Ordinal));
    }

    private static TargetTrack Track(int id, TrackState state, TargetMotion motion) => new()
    {
        Id = id,
        Class = DefaultTargetClasses.Red,
        State = state,
        Motion = motion,
        Position = GeodeticPosition.FromDegrees(47.3977, 8.5456, 488),
    };

    private static string TextOf(MissionStatus mission, params FollowTask[] followings)
        => TextOf(mission, TrackList.None, followings);

    private static string TextOf(MissionStatus mission, TrackList tracks, params FollowTask[] followings)
    {
        var record = new FlightRecord
        {
            Mission = mission,
            Tracks = tracks,
            Group = new GroupStatus { Followings = [.. followings] },
        };
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
