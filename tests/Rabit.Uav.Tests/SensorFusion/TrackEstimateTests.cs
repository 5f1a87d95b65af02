using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.SensorFusion;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.SensorFusion;

/// <summary>The exchange of tracks of targets that move between vehicles.</summary>
public sealed class TrackEstimateTests(ITestOutputHelper output)
{
    private static readonly TargetClassName Person = new("person");

    [Fact]
    public void Estimate_OfATargetThatIsNotSeenNow_MakesALateVehicleKnowIt()
    {
        using FusionRig first = Rig();
        Walk(first, 20);
        TrackEstimate sent = first.SentEstimates.Last().Content;
        using FusionRig late = Rig();
        late.Run(first.Now.TotalSeconds + 5);
        late.Push(sent with { SourceSystemId = 2 });
        late.Run(1.5);

        TargetTrack track = late.Only;
        Assert.Equal(TrackState.Tentative, track.State);
        Assert.Equal(sent.Time, track.Time);
        Assert.Equal(1, track.VelocityNed.North, 0.5);

        // Twice 2 m per axis are added: what its frame is off from ours.
        Assert.Equal(sent.Covariance.NorthNorth + 4, track.Covariance.NorthNorth, 1e-3);

        // Reports of our own make it a track like others, one does not; its velocity is known already.
        double north = FusionRig.PlaceOf(track).North + (late.Now - track.Time).TotalSeconds;
        for (int i = 1; i <= 3; i++)
        {
            late.Observe(north + (0.5 * i), 0, FusionRig.Report(north + (0.5 * i), 0, Person));
            Assert.Equal(track.Id, late.Only.Id);
            Assert.Equal(i < 3 ? TrackState.Tentative : TrackState.Confirmed, late.Only.State);
            Assert.InRange(late.Only.VelocityNed.North, 0.5, 1.5);
        }

        Assert.Equal(1, late.Counters.EstimatesUsed);
    }

    [Fact]
    public void Estimate_ReplayedAHundredTimes_ChangesNothing()
    {
        using FusionRig first = Rig();
        Walk(first, 20);
        TrackEstimate sent = first.SentEstimates.Last().Content with { SourceSystemId = 2 };
        using FusionRig late = Rig();
        late.Run(first.Now.TotalSeconds);
        late.Push(sent);
        late.Run(1.5);
        TargetTrack once = late.Only;
        for (int i = 0; i < 100; i++)
        {
            // Also one that is sent again later: the same picture of the same track.
            late.Push(sent with { Time = sent.Time + TimeSpan.FromMilliseconds(i) });
            late.Run(0.05);
        }

        late.Run(1.5);
        Assert.Equal(100, late.Counters.EstimatesTwice);
        Assert.Equal((once.Position, once.Covariance, once.Time), (
            late.Only.Position, late.Only.Covariance, late.Only.Time));
    }

    // Its reports are in ours already: the estimate, which is made of them too, makes us no surer.
    [Fact]
    public void Estimate_OfAVehicleWhoseReportsWeHave_IsNotCountedAgain()
    {
        using FusionRig first = Rig();
        using FusionRig second = Rig();
        for (int i = 0; i < 30; i++)
        {
            double north = 0.5 * i;
            first.Observe(0, 0, FusionRig.Report(north, 0, Person));
            second.Run(0.5);
            foreach (Envelope<TargetReport> report in first.SentReports)
                second.Push(report.Content with { SourceSystemId = 2 });
            first.SentReports.Clear();
        }

        second.Run(1.5);
        TargetTrack before = second.Only;
        TrackEstimate estimate = first.SentEstimates.Last().Content with { SourceSystemId = 2 };
        second.Push(estimate);
        second.Run(1.5);
        Assert.Equal(1, second.Counters.EstimatesNotNeeded);
        Assert.Equal(before.Covariance, second.Only.Covariance);
        Assert.Equal(before.Position, second.Only.Position);
    }

    // A second estimate of the same target, of whatever common origin: never surer than the surer one.
    [Fact]
    public void Estimates_OfTwoVehicles_AreFusedAndNoSurerThanTheSurerOne()
    {
        using FusionRig rig = Rig();
        rig.Run(10);
        rig.Push(FusionRig.Known(2, TimeSpan.FromSeconds(5), 5, new HorizontalCovariance(4, 0, 4)));
        rig.Run(1.5);
        Assert.Equal(8, rig.Only.Covariance.NorthNorth, 1e-6);
        rig.Push(FusionRig.Known(3, TimeSpan.FromSeconds(9), 9.5, new HorizontalCovariance(4, 0, 4)));
        rig.Run(1.5);

        Assert.Equal(2, rig.Counters.EstimatesUsed);
        Assert.Equal(TimeSpan.FromSeconds(9), rig.Only.Time);
        Assert.InRange(rig.Only.Covariance.NorthNorth, 7.99, 9);
        Assert.InRange(FusionRig.PlaceOf(rig.Only).North, 9, 9.6);
    }

    // The reports of the vehicle are off by the same as its estimate: a hundred do not make us surer than its frame is.
    [Fact]
    public void Estimate_ThenReportsOfTheSameVehicle_AreNoSurerThanItsFrame()
    {
        using FusionRig rig = Rig();
        rig.Run(1);
        rig.Push(FusionRig.Known(2, TimeSpan.FromSeconds(0.5), 0, new HorizontalCovariance(0.25, 0, 0.25)));
        rig.Run(1.5);
        for (int i = 0; i < 100; i++)
        {
            rig.Run(0.5);
            TargetReport report = FusionRig.Report(rig.Now.TotalSeconds - 0.5, 0, Person, sigma: 0.3, common: 2);
            rig.Push(report with { SourceSystemId = 2, PictureNumber = 500 + i, Time = rig.Now });
        }

        rig.Run(1);
        output.WriteLine($"variance {rig.Only.Covariance.NorthNorth:0.00} m2, {rig.Only.Reports} reports");
        Assert.InRange(rig.Only.Reports, 90, 100);
        Assert.InRange(rig.Only.Covariance.NorthNorth, 3.9, 5);
    }

    [Fact]
    public void Estimates_Hostile_AreRefusedByVehicleAndReason()
    {
        using FusionRig rig = Rig();
        rig.Run(60);
        TrackEstimate good = FusionRig.Known(7, rig.Now, 0, new HorizontalCovariance(1, 0, 1));
        var bad = new Dictionary<ReportFault, TrackEstimate[]>
        {
            [ReportFault.Identity] = [good with { TrackId = 0 }, good with { PictureNumber = -1 }],
            [ReportFault.Future] = [good with { Time = rig.Now + TimeSpan.FromSeconds(30) }],
            [ReportFault.TooOld] = [good with { Time = rig.Now - TimeSpan.FromSeconds(40) }],
            [ReportFault.Position] =
            [
                good with { VelocityNed = new NedVector(double.NaN, 0, 0) },
                good with { VelocityNed = new NedVector(0, 5000, 0) },
                good with { Position = GeodeticPosition.FromRadians(double.NaN, 0, 0) },
            ],
            [ReportFault.Covariance] =
            [
                good with { Covariance = new HorizontalCovariance(1, 2, 1) },
                good with { Covariance = new HorizontalCovariance(double.PositiveInfinity, 0, 1) },
                good with { VelocityCovariance = new HorizontalCovariance(-1, 0, 1) },
                good with { NorthWithNorthRate = 50 },
                good with { Covariance = new HorizontalCovariance(700, 0, 1) },
                good with { EastWithEastRate = double.NaN },
            ],
            [ReportFault.Description] = [good with { Class = TargetClassName.None }],
        };
        foreach (TrackEstimate estimate in bad.Values.SelectMany(e => e))
            rig.Push(estimate);
        rig.Run(1.5);

        Assert.Empty(rig.Tracks);
        Assert.Equal(bad.Values.Sum(e => e.Length), rig.Counters.EstimatesRefused);
        foreach ((ReportFault fault, TrackEstimate[] estimates) in bad.Select(b => (b.Key, b.Value)))
            Assert.Contains(new RefusedReports(7, fault, estimates.Length), rig.Counters.Refused);
        rig.Push(good with { Time = rig.Now });
        rig.Run(1.5);
        Assert.Single(rig.Tracks);
    }

    // Of a vehicle without a fix: our own camera must not be taken for the one that is far away.
    [Fact]
    public void Estimate_FarFromOurFirstReport_DoesNotHoldTheFrame()
    {
        using FusionRig rig = Rig();
        rig.Run(1);
        rig.Push(FusionRig.Known(2, TimeSpan.FromSeconds(0.5), 30_000, new HorizontalCovariance(1, 0, 1)));
        rig.Run(1.5);
        Walk(rig, 6);

        Assert.Equal(0, rig.Counters.ReportsRefused);
        Assert.Equal(6, rig.Only.Reports);
    }

    [Fact]
    public void Estimate_FarFromOurTracks_IsRefusedAndLeavesThem()
    {
        using FusionRig rig = Rig();
        rig.Observe(0, 0, FusionRig.Report(0, 0, Person));
        rig.Push(FusionRig.Known(2, rig.Now, 30_000, new HorizontalCovariance(1, 0, 1)));
        rig.Run(0.2);

        Assert.Equal(1, rig.Counters.EstimatesRefused);
        Assert.Equal(1, rig.Only.Reports);
    }

    [Fact]
    public void Estimates_OfMoreTracksThanHalfOfTheRoom_LeaveRoomForOurs()
    {
        using FusionRig rig = new(o =>
        {
            o.TargetMotions = o.TargetMotions.Add(Person, TargetMotion.Walking);
            o.SharesTracks = true;
            o.MaxTracks = 10;
        });
        rig.Run(1);
        for (int i = 0; i < 8; i++)
            rig.Push(FusionRig.Known(2, rig.Now, 100 * i, new HorizontalCovariance(1, 0, 1)) with { TrackId = i + 1 });
        rig.Run(1.5);

        Assert.Equal(5, rig.Tracks.Count);
        Assert.Equal(3, rig.Counters.EstimatesWithoutRoom);
        rig.Run(40);
        Assert.Empty(rig.Tracks);
    }

    [Fact]
    public void Estimates_OfTenTracks_GoOutInTurn()
    {
        using FusionRig rig = Rig();
        for (int i = 0; i < 60; i++)
            rig.Observe(0, 0, [.. Enumerable.Range(0, 10).Select(k => FusionRig.Report(0.5 * i, 20 * k, Person))]);

        Assert.Equal(10, rig.SentEstimates.Select(e => e.Content.TrackId).Distinct().Count());
    }

    [Fact]
    public void Estimates_OfTracksKnownFromOthersAlone_AreNotPassedOn()
    {
        using FusionRig rig = Rig();
        rig.Run(1);
        rig.Push(FusionRig.Known(2, TimeSpan.FromSeconds(1), 0, new HorizontalCovariance(1, 0, 1)));
        rig.Run(25);
        Assert.Single(rig.Tracks);
        Assert.Empty(rig.SentEstimates);
    }

    [Fact]
    public void Estimates_OfATargetThatIsSeen_GoOutEveryTenSeconds()
    {
        using FusionRig rig = Rig();
        Walk(rig, 80);
        Assert.InRange(rig.SentEstimates.Count, 4, 5);
        Assert.Equal(Person, rig.SentEstimates[0].Content.Class);
    }

    private static FusionRig Rig() => new(o =>
    {
        o.TargetMotions = o.TargetMotions.Add(Person, TargetMotion.Walking);
        o.SharesTracks = true;
    });

    private static void Walk(FusionRig rig, int pictures)
    {
        for (int i = 0; i < pictures; i++)
            rig.Observe(0.5 * i, 0, FusionRig.Report(0.5 * i, 0, Person));
        rig.Run(11);
    }
}
