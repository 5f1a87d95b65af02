using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using UavConsole;
using Xunit;

namespace Rabit.Uav.Tests.UavConsole;

/// <summary>Which track is which target, found, missed or false.</summary>
public sealed class TargetScoringTests
{
    private static readonly HorizontalCovariance OneMetre = new(1, 0, 1);
    private static readonly LocalNedFrame Frame = MadeUpFlight.Frame;

    [Fact]
    public void Score_TracksNearTheirTargets_AreFoundWithTheirErrors()
    {
        MissionScore score = Score([Target(DefaultTargetClasses.Red, 10, 20), Target(DefaultTargetClasses.Blue, 50, 60)], [Track(1, DefaultTargetClasses.Red, 11, 20), Track(2, DefaultTargetClasses.Blue, 50, 57)]);

        Assert.Equal((2, 0), (score.Found, score.FalseTracks.Count));
        Assert.Equal(1, score.Targets[0].ErrorMetres, 3);
        Assert.Equal((0, -3), (Math.Round(score.Targets[1].ErrorNorthMetres, 2), Math.Round(score.Targets[1].ErrorEastMetres, 2)));
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
    public void Score_TwoTracksAtOneTarget_TheNearerOneIsItAndTheOtherFalse()
    {
        MissionScore score = Score([Target(DefaultTargetClasses.Red, 0, 0)], [Track(1, DefaultTargetClasses.Red, 3, 0), Track(2, DefaultTargetClasses.Red, 0, 1)]);

        Assert.Equal(2, score.Targets[0].Track!.Id);
        Assert.Equal([1], score.FalseTracks.Select(t => t.Id));
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
        MissionScore score = Score([Target(DefaultTargetClasses.Red, 0, 0)], [Track(1, DefaultTargetClasses.Red, 0, 0, state)]);

        Assert.Equal((0, 0), (score.Found, score.FalseTracks.Count));
    }

    [Theory]
    [InlineData(2.4, true)]
    [InlineData(2.5, false)]
    public void Score_EllipseOfOneMetre_HoldsTruthTo95Percent(double north, bool holds)
    {
        // Half axis: the root of chi-square with two degrees of freedom, 2.4477 (Abramowitz and Stegun, table 26.8).
        MissionScore score = Score([Target(DefaultTargetClasses.Red, 0, 0)], [Track(1, DefaultTargetClasses.Red, north, 0)]);

        Assert.Equal(holds, score.Targets[0].EllipseHoldsTruth);
        Assert.Equal(holds ? 1 : 0, score.InEllipse);
    }

    [Fact]
    public void Judge_GoodFlight_Passes()
    {
        MissionOutcome outcome = MissionJudge.Judge(MadeUpFlight.Record(), MadeUpFlight.Truth, null);

        Assert.Empty(outcome.Failures);
        Assert.Equal(0.64, outcome.DistanceFromHomeMetres, 2);
        Assert.Equal(35, outcome.BatteryUsedPercent, 3);
    }

    [Fact]
    public void Judge_WithoutTruth_DoesNotJudgeTargets()
        => Assert.True(MissionJudge.Judge(MadeUpFlight.Record(finds: 0), null, null) is { HasPassed: true, Score: null });

    [Fact]
    public void Judge_StandsElsewhereInTruth_Fails()
    {
        MissionOutcome outcome = MissionJudge.Judge(MadeUpFlight.Record(), MadeUpFlight.Truth, Frame.ToGeodetic(new NedPosition(3.1, 0, 0)));

        Assert.Equal(["it landed 3.1 m from home"], outcome.Failures);
    }

    [Fact]
    public void Judge_OutsideTheFence_Fails()
    {
        FlightRecord good = MadeUpFlight.Record();
        var record = new FlightRecord
        {
            Samples = [.. good.Samples, new FlightSample { HasPosition = true, Position = Frame.ToGeodetic(new NedPosition(50, 204, -40)) }],
            Mission = good.Mission,
            Vehicle = good.Vehicle,
            Tracks = good.Tracks,
            GreatestHeightMetres = 40,
        };

        Assert.Equal(["it was 4.0 m outside the fence"], MissionJudge.Judge(record, MadeUpFlight.Truth, null).Failures);
    }

    private static MissionScore Score(IReadOnlyList<TruthTarget> targets, IReadOnlyList<TargetTrack> tracks)
        => TargetScoring.Score(new Truth(MadeUpFlight.Home, targets), tracks);

    // At another height than the tracks: a difference in height is no error.
    private static TruthTarget Target(TargetClassName colour, double north, double east) => new("target", colour, Frame.ToGeodetic(new NedVector(north, east, 7)));

    private static TargetTrack Track(int id, TargetClassName colour, double north, double east, TrackState state = TrackState.Confirmed) => new()
    {
        Id = id,
        Class = colour,
        State = state,
        Covariance = OneMetre,
        Position = Frame.ToGeodetic(new NedPosition(north, east, 0)),
    };
}
