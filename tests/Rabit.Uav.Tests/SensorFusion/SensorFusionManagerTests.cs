using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Tests.Shared;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.SensorFusion;
using Xunit;
using Xunit.Abstractions;
using static Rabit.Uav.Tests.SensorFusion.FusionRig;

namespace Rabit.Uav.Tests.SensorFusion;

public class SensorFusionManagerTests(ITestOutputHelper output)
{
    [Fact]
    public void Track_ThreeReportsInFiveObservations_IsConfirmed()
    {
        using var rig = new FusionRig();
        rig.Observe(0, 0, Report(3, 4));
        Assert.Equal(TrackState.Tentative, rig.Only.State);
        rig.Observe(0, 0);
        rig.Observe(0, 0, Report(3.1, 4));
        rig.Observe(0, 0);
        Assert.Equal(TrackState.Tentative, rig.Only.State);
        rig.Observe(0, 0, Report(3, 4.1));
        TargetTrack track = rig.Only;
        Assert.Equal((TrackState.Confirmed, 1, 3, 2), (track.State, track.Id, track.Reports, track.Misses));
        Assert.Equal(3.03, PlaceOf(track).North, 0.05);
        Assert.Equal(4.03, PlaceOf(track).East, 0.05);
        Assert.Equal(488, track.Position.AltitudeAmslMetres, 0.01);
        Assert.Equal(rig.Now, rig.List.Time);
    }

    [Fact]
    public void Track_MissedTooOftenBeforeItIsConfirmed_IsDeleted()
    {
        using var rig = new FusionRig();
        rig.Observe(0, 0, Report(3, 4));
        rig.Observe(0, 0);
        rig.Observe(0, 0);
        Assert.Single(rig.Tracks);
        rig.Observe(0, 0);
        Assert.Empty(rig.Tracks);
        Assert.Equal(1, rig.Counters.TracksDropped);
        rig.Observe(0, 0, Report(3, 4));
        Assert.Equal(2, rig.Only.Id);
    }

    [Fact]
    public void Track_OutsideEveryPicture_StaysConfirmed()
    {
        using var rig = new FusionRig();
        Confirm(rig);
        for (int i = 0; i < 200; i++)
            rig.Observe(60, 0);
        Assert.Equal((TrackState.Confirmed, 0), (rig.Only.State, rig.Only.Misses));
    }

    [Fact]
    public void Track_AtTheBorderOfThePicture_IsNoMiss()
    {
        using var rig = new FusionRig();
        Confirm(rig);
        for (int i = 0; i < 20; i++)
            rig.Observe(17.5, 0);
        Assert.Equal(0, rig.Only.Misses);
        rig.Observe(13, 0);
        Assert.Equal(1, rig.Only.Misses);
    }

    [Fact]
    public void Track_NotSeenWhereItShouldBe_IsLostAndFoundAgain()
    {
        using var rig = new FusionRig();
        Confirm(rig);
        for (int i = 0; i < 5; i++)
            rig.Observe(0, 0);
        Assert.Equal(TrackState.Confirmed, rig.Only.State);
        rig.Observe(0, 0);
        Assert.Equal(TrackState.Lost, rig.Only.State);
        Assert.Empty(rig.List.Confirmed);
        for (int i = 0; i < 3; i++)
            rig.Observe(0, 0, Report(0, 0));
        Assert.Equal((TrackState.Confirmed, 1), (rig.Only.State, rig.Only.Id));
    }

    [Fact]
    public void Track_TentativeAndNotSeenForLong_IsDropped()
    {
        using var rig = new FusionRig();
        rig.Observe(0, 0, Report(3, 4));
        rig.Run(110);
        rig.Observe(200, 0);
        Assert.Single(rig.Tracks);
        rig.Run(10);
        rig.Observe(200, 0);
        Assert.Empty(rig.Tracks);
    }

    [Fact]
    public void Observation_OneOfItsReportsIsNotValid_TheOthersCount()
    {
        using var rig = new FusionRig();
        for (int i = 0; i < 3; i++)
            rig.Observe(0, 0, Report(0, 0), Report(9, 9) with { Score = double.NaN });
        Assert.Equal((TrackState.Confirmed, 3, 0), (rig.Only.State, rig.Only.Reports, rig.Only.Misses));
        Assert.Equal((3L, 3L), (rig.Counters.Observations, rig.Counters.ReportsRefused));
    }

    [Fact]
    public void Report_OtherClass_IsAnotherTrack()
    {
        using var rig = new FusionRig();
        for (int i = 0; i < 3; i++)
            rig.Observe(0, 0, Report(0, 0), Report(0.2, 0, DefaultTargetClasses.Orange));
        Assert.Equal([DefaultTargetClasses.Red, DefaultTargetClasses.Orange], rig.Tracks.Select(t => t.Class));
        Assert.All(rig.Tracks, t => Assert.Equal(3, t.Reports));
    }

    [Fact]
    public void Report_OutsideTheGate_StartsATrack()
    {
        using var rig = new FusionRig(o => o.SharesReports = false);
        rig.Observe(0, 0, Report(0, 0));

        // S is the track's 0.25, the report's 0.25 and the common 0.25: the gate ends at sqrt(9.21 x 0.75) = 2.63 m.
        rig.Observe(0, 0, Report(2.6, 0));
        Assert.Single(rig.Tracks);
        using var other = new FusionRig();
        other.Observe(0, 0, Report(0, 0));
        other.Observe(0, 0, Report(2.66, 0));
        Assert.Equal(2, other.Tracks.Count);
    }

    [Fact]
    public void Report_NextPassOnTheOppositeHeading_IsOfTheSameTarget()
    {
        using var rig = new FusionRig();
        for (int i = 0; i < 8; i++)
            rig.Observe(0, 0, Report(0, 0, common: 1.5));
        rig.Run(30);
        rig.Observe(0, 0, Report(5.2, 0, common: 1.5));
        Assert.Equal(9, rig.Only.Reports);

        using var samePass = new FusionRig();
        for (int i = 0; i < 8; i++)
            samePass.Observe(0, 0, Report(0, 0, common: 1.5));
        samePass.Observe(0, 0, Report(5.2, 0, common: 1.5));
        Assert.Equal(2, samePass.Tracks.Count);
    }

    [Fact]
    public void Report_OfAVehicleThatSawItAfterAnother_IsOfTheSameTarget()
    {
        using var rig = new FusionRig();
        for (int i = 0; i < 8; i++)
            rig.Observe(0, 0, Report(0, 0, common: 1.5));
        foreach ((int number, double north) in new[] { (1, 2.0), (2, 5.2) })
        {
            rig.Push(Report(north, 0, common: 1.5) with
            {
                SourceSystemId = 2,
                PictureNumber = number,
                Time = rig.Now,
            });
            rig.Run(1);
        }

        Assert.Equal(10, rig.Only.Reports);
    }

    [Fact]
    public void Track_ErrorOfTheMountTurnsWithTheHeading_StaysWhereItIs()
    {
        using var rig = new FusionRig();
        foreach (double mount in new[] { 1.5, -1.5 })
        {
            for (int i = 0; i < 8; i++)
                rig.Observe(0, 0, Report(mount, 0, common: 1.5));
            rig.Run(20);
        }

        Assert.Equal(0, rig.Only.VelocityNed.HorizontalLength);
        rig.Run(220);
        rig.Observe(0, 0, Report(0, 0, common: 1.5));
        Assert.Equal(17, rig.Only.Reports);
        Assert.Equal(0, PlaceOf(rig.Only).North, 0.01);
    }

    [Fact]
    public void Report_TwoTargetsSideBySide_AreNotExchangedNorMerged()
    {
        using var rig = new FusionRig();
        for (int i = 0; i < 20; i++)
            rig.Observe(0, 0, i % 2 == 0 ? [Report(0, 0), Report(2, 0)] : [Report(2, 0), Report(0, 0)]);
        for (int i = 0; i < 5; i++)
            rig.Observe(0, 0, Report(0, 0));
        Assert.Equal([0.0, 2.0], rig.Tracks.Select(t => Math.Round(PlaceOf(t).North, 1)));
        Assert.Equal(0, rig.Counters.TracksMerged);
    }

    [Fact]
    public void Tracks_TwoOfOneTarget_BecomeOne()
    {
        using var rig = new FusionRig();
        rig.Observe(0, 0, Report(0, 0, sigma: 0.3, common: 1));
        rig.Observe(0, 0, Report(3.4, 0, sigma: 0.3, common: 1));
        Assert.Equal(2, rig.Tracks.Count);
        for (int i = 0; i < 8; i++)
            rig.Observe(0, 0, Report(1.7, 0, sigma: 0.3, common: 1));
        Assert.Equal(1, rig.Only.Id);
        Assert.Equal(1, rig.Counters.TracksMerged);
        Assert.Equal(10, rig.Only.Reports);
        Assert.Equal(1.7, PlaceOf(rig.Only).North, 0.1);
    }

    [Fact]
    public void VehicleMessages_ConfirmedTrack_IsSharedOnceASecond()
    {
        using var rig = new FusionRig();
        for (int i = 0; i < 22; i++)
            rig.Observe(0, 0, Report(0, 0));
        Assert.InRange(rig.SentReports.Count, 9, 11);
        Assert.All(
            rig.SentReports,
            m => Assert.Equal(
                (VehicleDestination.All, 0, 1), (m.Destination, m.SourceSystemId, m.Content.SourceSystemId)));
    }

    [Fact]
    public void Posts_NothingChanged_NothingIsPosted()
    {
        using var rig = new FusionRig();
        Confirm(rig);
        int posts = rig.Posts;
        for (int i = 0; i < 20; i++)
            rig.Observe(100, 0);
        Assert.Equal(posts, rig.Posts);
    }

    [Fact]
    public void Covariance_CommonPart_DoesNotAverageOut()
    {
        using var rig = new FusionRig();
        for (int i = 0; i < 100; i++)
            rig.Observe(0, 0, Report(0, 0, sigma: 0.5, common: 1.5));
        Assert.InRange(rig.Only.Covariance.NorthNorth, 1.5 * 1.5, (1.5 * 1.5) + 0.02);
    }

    [Theory]
    [InlineData(21)]
    [InlineData(22)]
    public void Tracks_ClutterAndMisses_OnlyTheTargetsAreConfirmed(int seed)
    {
        output.WriteLine($"seed {seed}");
        var random = new SeededNumbers(seed);
        (double North, double East)[] targets = [(0, 0), (8, -12), (-10, 15)];
        using var rig = new FusionRig();
        for (int picture = 0; picture < 120; picture++)
        {
            List<TargetReport> reports = targets.Where(_ => random.Uniform() < 0.9)
                .Select(t => Report(t.North + (0.5 * random.Gauss()), t.East + (0.5 * random.Gauss()))).ToList();
            if (random.Uniform() < 0.3)
                reports.Add(Report(random.Uniform(-18, 18), random.Uniform(-24, 24)));
            rig.Observe(0, 0, [.. reports]);
        }

        List<TargetTrack> sure = rig.List.Confirmed.ToList();
        Assert.Equal(3, sure.Count);
        Assert.All(targets, t => Assert.Single(
            sure, s => Math.Abs(PlaceOf(s).North - t.North) < 0.7 && Math.Abs(PlaceOf(s).East - t.East) < 0.7));
    }

    [Fact]
    public void Tracks_ObservationsOnTwoHeadings_AreOneTrackWithAConsistentCovariance()
    {
        const int Seed = 31;
        output.WriteLine($"seed {Seed}");
        var random = new SeededNumbers(Seed);
        int held = 0;
        const int Runs = 60;
        for (int run = 0; run < Runs; run++)
        {
            // A mount that points half a metre off to the side, and satellites that are a metre off.
            (double mount, double gpsNorth, double gpsEast) = (0.5 * random.Gauss(), random.Gauss(), random.Gauss());
            using var rig = new FusionRig();
            for (int pass = 0; pass < 2; pass++)
            {
                double sign = pass == 0 ? 1 : -1;
                for (int i = 0; i < 8; i++)
                    rig.Observe(0, 0, Report(
                        gpsNorth + (sign * mount) + (0.5 * random.Gauss()), gpsEast + (0.5 * random.Gauss()),
                        sigma: 0.5, common: 1.12));
                rig.Run(30);
            }

            NedPosition place = PlaceOf(rig.Tracks[0]);
            held += rig.Tracks[0].Covariance.Contains95(place.North, place.East) ? 1 : 0;
            Assert.Single(rig.Tracks);
        }

        output.WriteLine($"{held} of {Runs} held");
        Assert.InRange(held, 0.85 * Runs, Runs);
    }

    [Fact]
    public void ExecuteUnitOfWork_NothingComes_AllocatesNothing()
    {
        using var rig = new FusionRig();
        Confirm(rig);
        rig.Run(5);
        Assert.Equal(0, Allocated.By(() => rig.Run(60)));
    }

    [Fact]
    public void Constructor_BadOptions_NamesAllFaults()
    {
        ArgumentException e = Assert.Throws<ArgumentException>(() => new SensorFusionManager(new SensorFusionOptions
        {
            Gate = double.NaN,
            ConfirmHits = 6,
            MaxTracks = 0,
        }));
        Assert.Contains("Gate is NaN", e.Message, StringComparison.Ordinal);
        Assert.Contains("ConfirmHits is 6", e.Message, StringComparison.Ordinal);
        Assert.Contains("MaxTracks is 0", e.Message, StringComparison.Ordinal);
    }

    private static void Confirm(FusionRig rig)
    {
        for (int i = 0; i < 3; i++)
            rig.Observe(0, 0, Report(0, 0));
        Assert.Equal(TrackState.Confirmed, rig.Only.State);
    }
}
