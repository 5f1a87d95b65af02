using System;
using System.IO;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>What one vehicle of a group takes for a target, and is none, is false for the group.</summary>
public sealed class GroupFalseTracksTests
{
    [Fact]
    public void WithFalseTracksOf_OnlyAnotherVehicleHasThem_CountsEachStandingOneOnce()
    {
        TargetTrack own = Track(1, 0);
        TargetTrack standing = Track(2, 100);
        TargetTrack moving = Track(3, 200, TargetMotion.Walking);
        GroupFlightSummary group = Group(default, own, standing);
        var best = new MissionScore { FalseTracks = [own], IdentitySwitches = 2, DistanceFromHomeMetres = 1.5 };

        MissionScore all = group.WithFalseTracksOf(
            best,
            [
                new MissionScore { FalseTracks = [Track(7, 3), standing, moving] },
                new MissionScore { FalseTracks = [Track(8, 104)] },
            ]);

        Assert.Equal([own, standing], all.FalseTracks);
        Assert.Same(best.Targets, all.Targets);
        Assert.Equal((2, 1.5), (all.IdentitySwitches, all.DistanceFromHomeMetres));
    }

    // To be asked is what the second vehicle is for.
    [Theory]
    [InlineData(ValidationResult.Rejected, 0)]
    [InlineData(ValidationResult.Unknown, 1)]
    [InlineData(ValidationResult.Confirmed, 1)]
    public void WithFalseTracksOf_ASecondVehicleRejectedIt_DoesNotCount(ValidationResult result, int expected)
    {
        TargetTrack track = Track(2, 100);
        var task = new ValidationTask
        {
            Finder = 2,
            Number = 1,
            State = ValidationState.Closed,
            Validator = 1,
            Result = result,
            Class = track.Class,
            Position = track.Position,
        };

        MissionScore all = Group(task, track).WithFalseTracksOf(
            new MissionScore(), [new MissionScore { FalseTracks = [track] }]);

        Assert.Equal((expected, 1 - expected), (all.FalseTracks.Count, all.RejectedTracks.Count));
    }

    // The first vehicle was out of reach when the second one rejected it.
    [Fact]
    public void WithFalseTracksOf_OwnTrackThatAnotherVehicleRejected_IsRejectedOnceAndNotFalse()
    {
        TargetTrack own = Track(2, 100);
        TargetTrack theirs = Track(9, 102);
        var task = new ValidationTask
        {
            Finder = 2,
            Number = 1,
            State = ValidationState.Closed,
            Validator = 3,
            Result = ValidationResult.Rejected,
            Class = theirs.Class,
            Position = theirs.Position,
        };

        MissionScore all = Group(task, theirs).WithFalseTracksOf(
            new MissionScore { FalseTracks = [own] }, [new MissionScore { RejectedTracks = [theirs] }]);

        Assert.Empty(all.FalseTracks);
        Assert.Equal([own], all.RejectedTracks);
    }

    [Fact]
    public void Write_FalseTrackOfAnotherVehicle_IsNamedWithItsVehicle()
    {
        TargetTrack track = Track(2, 100);
        GroupFlightSummary group = Group(default, track);
        using var page = new StringWriter();
        GroupHtmlReport.Write(
            page, new GroupFlightSummary(group.Vehicles) { Score = new MissionScore { FalseTracks = [track] } });
        Assert.Contains(
            "vehicle 2 alone has a confirmed track of red at 47.3979000, 8.5456000, where there is no target",
            page.ToString());
    }

    private static TargetTrack Track(int id, double metresNorth, TargetMotion motion = TargetMotion.Standing) => new()
    {
        Id = id,
        Class = DefaultTargetClasses.Red,
        State = TrackState.Confirmed,
        Motion = motion,
        Position = GeodeticPosition.FromDegrees(47.397 + (metresNorth * 9e-6), 8.5456, 488),
    };

    // The first vehicle knows the most: it has two tracks more.
    private static GroupFlightSummary Group(ValidationTask task, params TargetTrack[] ofTheSecond) => new(
    [
        Vehicle(1, default, Track(21, 500), Track(22, 600), Track(23, 700)),
        Vehicle(2, task, ofTheSecond),
    ]);

    private static GroupVehicleSummary Vehicle(byte systemId, ValidationTask task, params TargetTrack[] tracks)
    {
        var record = new FlightRecord
        {
            Tracks = new TrackList(TimeSpan.Zero, [.. tracks]),
            Group = new GroupStatus { Validations = task.Finder == 0 ? [] : [task] },
        };
        return new GroupVehicleSummary(
            systemId, new FlightSummary(record) { Mission = new MissionSummary(record, score: null) });
    }
}
