using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Scoring;

/// <summary>Which track is which target, found, missed or false.</summary>
public sealed class TargetScoringTests
{
    private static readonly HorizontalCovariance OneMetre = new(1, 0, 1);
    private static readonly GeodeticPosition Home = GeodeticPosition.FromDegrees(47.39697, 8.54426, 488);
    private static readonly LocalNedFrame Frame = LocalNedFrame.IgnoringGeoid(Home);

    [Fact]
    public void Score_TracksNearTheirTargets_AreFoundWithTheirErrors()
    {
        MissionScore score = Score(
            [Target(DefaultTargetClasses.Red, 10, 20), Target(DefaultTargetClasses.Blue, 50, 60)],
            [Track(1, DefaultTargetClasses.Red, 11, 20), Track(2, DefaultTargetClasses.Blue, 50, 57)]);

        Assert.Equal((2, 0), (score.Found, score.FalseTracks.Count));
        Assert.Equal(1, score.Targets[0].ErrorMetres, 3);
        Assert.Equal(
            (0, -3),
            (Math.Round(score.Targets[1].ErrorNorthMetres, 2), Math.Round(score.Targets[1].ErrorEastMetres, 2)));
        Assert.Equal(Math.Sqrt(5), score.RmseMetres, 3);
    }

    [Fact]
    public void Score_OtherColourOrTooFar_IsMissedAndFalse()
    {
        MissionScore score = Score(
            [Target(DefaultTargetClasses.Red, 0, 0), Target(DefaultTargetClasses.Blue, 50, 0)],
            [Track(1, DefaultTargetClasses.Orange, 0, 0), Track(2, DefaultTargetClasses.Blue, 60.1, 0)]);

        Assert.Equal(0, score.Found);
        Assert.Equal([1, 2], score.FalseTracks.Select(t => t.Id));
        Assert.True(double.IsNaN(score.RmseMetres));
    }

    [Fact]
    public void Score_TrackThatTheOperatorRejected_IsNotFoundButRejected()
    {
        MissionScore score = Score(
            TwoReds(),
            [
                Track(1, DefaultTargetClasses.Red, 0, 0), Track(2, DefaultTargetClasses.Red, 2, 0, TrackState.Rejected),
                Track(3, DefaultTargetClasses.Red, 101, 0, TrackState.Rejected),
            ]);

        Assert.Equal([true, false], score.Targets.Select(t => t.IsFound));
        Assert.Equal([false, true], score.Targets.Select(t => t.IsRejected));
        Assert.Empty(score.FalseTracks);
        Assert.Equal("was seen, and rejected by the operator", FlightText.Missed(score.Targets[1]));
    }

    [Fact]
    public void Score_RejectedTrackOfATargetThatWasFound_ItsNeighbourIsNotRejected()
    {
        MissionScore score = Score(
            [Target(DefaultTargetClasses.Red, 0, 0), Target(DefaultTargetClasses.Red, 6, 0)],
            [Track(1, DefaultTargetClasses.Red, 0, 0), Track(2, DefaultTargetClasses.Red, 1, 0, TrackState.Rejected)]);

        Assert.Equal([true, false], score.Targets.Select(t => t.IsFound));
        Assert.All(score.Targets, t => Assert.False(t.IsRejected));
    }

    [Fact]
    public void Score_TracksThatAnotherVehicleRejected_AreRejectedAndNeitherFoundNorFalse()
    {
        MissionScore score = ScoreInGroup(
            [Track(1, DefaultTargetClasses.Red, 1, 0), Track(2, DefaultTargetClasses.Red, 50, 0)],
            Task(2, ValidationResult.Rejected, 0), Task(3, ValidationResult.Rejected, 52));

        Assert.Equal((0, 0), (score.Found, score.FalseTracks.Count));
        Assert.Equal([2], score.RejectedTracks.Select(t => t.Id));
        Assert.Equal([true, false], score.Targets.Select(t => t.IsRejectedByVehicle));
        Assert.Equal(
            ["was seen, and rejected by the vehicle that validated it", "was not found"],
            score.Targets.Select(FlightText.Missed));
    }

    [Theory]
    [InlineData(ValidationResult.Unknown, 2, "red", 0)]
    [InlineData(ValidationResult.Confirmed, 2, "red", 0)]
    [InlineData(ValidationResult.Rejected, 1, "red", 0)]   // by the operator: the track says so
    [InlineData(ValidationResult.Rejected, 2, "blue", 0)]
    [InlineData(ValidationResult.Rejected, 2, "red", 10.1)]
    public void Score_NoOtherVehicleRejectedTheTrack_IsFalse(
        ValidationResult result, byte validator, string ofClass, double metresAway)
    {
        MissionScore score = ScoreInGroup(
            [Track(1, DefaultTargetClasses.Red, 50, 0)],
            Task(validator, result, 50 + metresAway) with { Class = new TargetClassName(ofClass) });

        Assert.Equal([1], score.FalseTracks.Select(t => t.Id));
        Assert.Empty(score.RejectedTracks);
    }

    // Two vehicles announced it: one task was left to the other.
    [Fact]
    public void Score_NearerTaskHasNoResult_TheOneWithAResultCounts()
    {
        MissionScore score = ScoreInGroup(
            [Track(1, DefaultTargetClasses.Red, 50, 0)],
            Task(2, ValidationResult.Unknown, 50), Task(3, ValidationResult.Rejected, 52));

        Assert.Empty(score.FalseTracks);
        Assert.Equal([1], score.RejectedTracks.Select(t => t.Id));
    }

    [Fact]
    public void Score_RejectedTrackBesideAConfirmedOne_EachHasItsOwnResult()
    {
        MissionScore score = ScoreInGroup(
            [Track(1, DefaultTargetClasses.Red, 0, 0), Track(2, DefaultTargetClasses.Red, 8, 0)],
            Task(2, ValidationResult.Rejected, 7), Task(2, ValidationResult.Confirmed, 1));

        Assert.Equal(1, score.Targets[0].Track!.Id);
        Assert.Equal([2], score.RejectedTracks.Select(t => t.Id));
    }

    [Fact]
    public void Score_TwoTracksAtOneTarget_TheNearerOneIsItsAndTheOtherFalse()
    {
        MissionScore score = Score(
            [Target(DefaultTargetClasses.Red, 0, 0)],
            [Track(1, DefaultTargetClasses.Red, 3, 0), Track(2, DefaultTargetClasses.Red, 0, 1)]);

        Assert.Equal(2, score.Targets[0].Track!.Id);
        Assert.Equal([1], score.FalseTracks.Select(t => t.Id));
    }

    [Theory]
    [InlineData(TargetMotion.Vehicle, 30, 0)]
    [InlineData(TargetMotion.Vehicle, 15, 1)]
    [InlineData(TargetMotion.Standing, 30, 1)]
    public void Score_SecondTrackOfATarget_IsFalseUnlessItMovesAndIsSeenAgain(
        TargetMotion motion, int againSeconds, int falseTracks)
    {
        TargetTrack Seen(int id, double north, int from) => new()
        {
            Id = id,
            State = TrackState.Confirmed,
            Class = DefaultTargetClasses.Red,
            Motion = motion,
            Position = Frame.ToGeodetic(new NedPosition(north, 0, 0)),
            Covariance = OneMetre,
            FirstSeen = TimeSpan.FromSeconds(from),
            LastSeen = TimeSpan.FromSeconds(from + 10),
        };

        MissionScore score = Score(
            [Target(DefaultTargetClasses.Red, 0, 0)], [Seen(1, 1, 10), Seen(2, 3, againSeconds)]);

        Assert.Equal((1, falseTracks), (score.Found, score.FalseTracks.Count));
        Assert.Equal(1, score.Targets[0].Track!.Id);
    }

    [Fact]
    public void Score_TwoTargetsNearEachOther_EachHasItsOwnTrack()
    {
        MissionScore score = Score(
            [Target(DefaultTargetClasses.Red, 0, 0), Target(DefaultTargetClasses.Red, 8, 0)],
            [Track(1, DefaultTargetClasses.Red, 7, 0), Track(2, DefaultTargetClasses.Red, 1.5, 0)]);

        Assert.Equal([2, 1], score.Targets.Select(t => t.Track!.Id));
    }

    [Theory]
    [InlineData(TrackState.Tentative)]
    [InlineData(TrackState.Lost)]
    public void Score_TrackThatIsNotConfirmed_CountsForNothing(TrackState state)
    {
        MissionScore score = Score(
            [Target(DefaultTargetClasses.Red, 0, 0)], [Track(1, DefaultTargetClasses.Red, 0, 0, state)]);

        Assert.Equal((0, 0), (score.Found, score.FalseTracks.Count));
    }

    [Theory]
    [InlineData(2.4, true)]
    [InlineData(2.5, false)]
    public void Score_EllipseOfOneMetre_ContainsTruthTo95Percent(double north, bool contains)
    {
        // Half axis: the root of chi-square with two degrees of freedom, 2.4477 (Abramowitz and Stegun, table 26.8).
        MissionScore score = Score(
            [Target(DefaultTargetClasses.Red, 0, 0)], [Track(1, DefaultTargetClasses.Red, north, 0)]);

        Assert.Equal(contains, score.Targets[0].EllipseContainsTruth);
        Assert.Equal(contains ? 1 : 0, score.InEllipse);
    }

    [Fact]
    public void Score_OfARecord_HasTheTrueDistanceFromThePlansHome()
    {
        var record = new FlightRecord { Mission = new MissionStatus { Plan = new SearchPlan { Home = Home } } };
        var truth = new TargetTruth(Home, []);

        Assert.Equal(3.1, TargetScoring.Score(
            truth, record, Frame.ToGeodetic(new NedPosition(3.1, 0, 0))).DistanceFromHomeMetres!.Value, 6);
        Assert.Null(TargetScoring.Score(truth, record, null).DistanceFromHomeMetres);
        Assert.Null(TargetScoring.Score(truth, FlightRecord.Empty, Home).DistanceFromHomeMetres);
    }

    // Two targets of one class are exchanged while both are out of sight: one track ends where the other one began.
    [Fact]
    public void Score_TrackWentOverToAnotherTarget_IsAnIdentitySwitchAndNoneIsFalse()
    {
        (TargetTrack, TrackPath)[] tracks =
        [
            Walk(1, s => s <= 10 ? 0 : s >= 20 && s <= 30 ? 100 : null),
            Walk(2, s => s <= 10 ? 100 : null),
            Walk(3, s => s >= 20 && s <= 30 ? 0 : null),
        ];
        MissionScore score = ScoreWalks(tracks);
        Assert.Equal((2, 0, 1), (score.Found, score.FalseTracks.Count, score.IdentitySwitches));
        Assert.Single(Score(TwoReds(), [.. tracks.Select(t => t.Item1)]).FalseTracks);
    }

    [Theory]
    [InlineData(3)]
    [InlineData(25)]
    public void Score_TrackOfAMovingClassBesideAnotherOrOfNothing_IsFalse(double north)
    {
        MissionScore score = ScoreWalks(
            Walk(1, s => s <= 20 ? 1 : null), Walk(2, s => s <= 15 ? north : null), Walk(3, _ => 100));
        Assert.Equal([2], score.FalseTracks.Select(t => t.Id));
        Assert.Equal((2, 0), (score.Found, score.IdentitySwitches));
    }

    // Two that pass each other within the gate.
    [Fact]
    public void Score_TracksThatPassEachOther_AreNoIdentitySwitch()
    {
        MissionScore score = ScoreWalks(Walk(1, s => s is 8 or 9 ? 96 : 0), Walk(2, _ => 100));
        Assert.Equal((2, 0, 0), (score.Found, score.FalseTracks.Count, score.IdentitySwitches));
    }

    private static MissionScore ScoreWalks(params (TargetTrack Track, TrackPath Path)[] walks) => TargetScoring.Score(
        new TargetTruth(Home, TwoReds()),
        new FlightRecord
        {
            Tracks = new TrackList(TimeSpan.Zero, [.. walks.Select(w => w.Track)]),
            MovingTrackPaths = [.. walks.Select(w => w.Path)],
        },
        null);

    private static MissionScore ScoreInGroup(TargetTrack[] tracks, params ValidationTask[] tasks)
        => TargetScoring.Score(
            new TargetTruth(Home, TwoReds()),
            new FlightRecord
            {
                Tracks = new TrackList(TimeSpan.Zero, [.. tracks]),
                Group = new GroupStatus { Validations = [.. tasks] },
            },
            null);

    private static ValidationTask Task(byte validator, ValidationResult result, double north) => new()
    {
        Finder = 1,
        State = ValidationState.Closed,
        Class = DefaultTargetClasses.Red,
        Position = Frame.ToGeodetic(new NedPosition(north, 0, 0)),
        Validator = validator,
        Result = result,
    };

    private static TruthTarget[] TwoReds()
        => [Target(DefaultTargetClasses.Red, 0, 0), Target(DefaultTargetClasses.Red, 100, 0)];

    // Where it is to the north in each second; null while it is not seen.
    private static (TargetTrack, TrackPath) Walk(int id, Func<int, double?> north)
    {
        TrackPoint[] points =
        [
            .. Enumerable.Range(0, 31).Where(s => north(s) is not null).Select(s => new TrackPoint(
                TimeSpan.FromSeconds(s), Frame.ToGeodetic(new NedPosition(north(s)!.Value, 0, 0)))),
        ];
        var track = new TargetTrack
        {
            Id = id,
            State = TrackState.Confirmed,
            Class = DefaultTargetClasses.Red,
            Motion = TargetMotion.Walking,
            Position = points[points.Length - 1].Position,
            Covariance = OneMetre,
            Time = points[points.Length - 1].Time,
            FirstSeen = points[0].Time,
            LastSeen = points[points.Length - 1].Time,
        };
        return (track, new TrackPath(id, points));
    }

    private static MissionScore Score(IReadOnlyList<TruthTarget> targets, IReadOnlyList<TargetTrack> tracks)
        => TargetScoring.Score(new TargetTruth(Home, targets), tracks);

    // At another height than the tracks: a difference in height is no error.
    private static TruthTarget Target(TargetClassName colour, double north, double east)
        => new("target", colour, Frame.ToGeodetic(new NedPosition(north, east, 7)));

    private static TargetTrack Track(
        int id, TargetClassName colour, double north, double east, TrackState state = TrackState.Confirmed)
        => new()
        {
            Id = id,
            Class = colour,
            State = state,
            Covariance = OneMetre,
            Position = Frame.ToGeodetic(new NedPosition(north, east, 0)),
        };
}
