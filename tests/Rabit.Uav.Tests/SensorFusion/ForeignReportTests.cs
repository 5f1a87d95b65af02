using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Xunit;
using static Rabit.Uav.Tests.SensorFusion.FusionRig;

namespace Rabit.Uav.Tests.SensorFusion;

/// <summary>Reports of other vehicles, late ones, doubled ones and hostile ones.</summary>
public class ForeignReportTests
{
    [Fact]
    public void Report_OfAnotherVehicle_IsTakenAfterAWhileAndNotSentOn()
    {
        using var rig = new FusionRig();
        Confirm(rig);
        int sent = rig.SentReports.Count;
        for (int i = 0; i < 4; i++)
        {
            TargetReport report = Report(0.5, 0.5);
            (report.SourceSystemId, report.PictureNumber, report.Time, report.Score) = (2, i, rig.Now, 1);
            rig.Push(report);
            rig.Run(0.3);
            Assert.Equal(3 + i, rig.Only.Reports);
            rig.Run(0.7);
            Assert.Equal(4 + i, rig.Only.Reports);
        }

        Assert.Equal(sent, rig.SentReports.Count);
        Assert.InRange(rig.Only.BestPictureNumber, 1, 3);
    }

    [Fact]
    public void Report_OfAnotherVehicleOnly_IsConfirmedWithoutPicture()
    {
        using var rig = new FusionRig();
        for (int i = 0; i < 3; i++)
        {
            TargetReport report = Report(0.5, 0.5);
            (report.SourceSystemId, report.PictureNumber, report.Time) = (2, i, rig.Now);
            rig.Push(report);
            rig.Run(1);
        }

        Assert.Equal((TrackState.Confirmed, -1L), (rig.Only.State, rig.Only.BestPictureNumber));
    }

    [Fact]
    public void Report_Twice_CountsOnce()
    {
        using var rig = new FusionRig();
        TargetReport report = Report(0, 0);
        (report.SourceSystemId, report.PictureNumber, report.Time) = (2, 7, rig.Now);
        for (int i = 0; i < 5; i++)
        {
            rig.Push(report);
            rig.Run(1);
        }

        Assert.Equal(1, rig.Only.Reports);
        Assert.Equal(4, rig.Counters.ReportsTwice);
    }

    [Fact]
    public void Report_Late_IsUsedWithinTheWindowAndDroppedAfter()
    {
        using var rig = new FusionRig();
        rig.Run(60);
        Confirm(rig);
        void PushOlder(int number, double seconds)
        {
            TargetReport report = Report(0, 0);
            (report.SourceSystemId, report.PictureNumber, report.Time) =
                (2, number, rig.Only.Time - TimeSpan.FromSeconds(seconds));
            rig.Push(report);
            rig.Run(1);
        }

        PushOlder(1, 9);
        Assert.Equal((4, 0L), (rig.Only.Reports, rig.Counters.ReportsLate));
        PushOlder(2, 11);
        Assert.Equal((4, 1L), (rig.Only.Reports, rig.Counters.ReportsLate));
    }

    [Fact]
    public void Reports_Hostile_AreRefusedAndHarmNothing()
    {
        using var rig = new FusionRig();
        Confirm(rig);
        string before = Describe(rig.Only);
        TargetReport[] hostile = HostileReports(rig.Now).ToArray();
        for (int i = 0; i < hostile.Length; i++)
        {
            hostile[i].PictureNumber = hostile[i].PictureNumber < 0 ? -1 : 100 + i;
            rig.Push(hostile[i]);
        }

        rig.Run(2);
        Assert.Equal(hostile.Length, rig.Counters.ReportsRefused);
        Assert.Equal(before, Describe(rig.Only));
    }

    [Fact]
    public void Observations_Hostile_AreRefusedOrShowNothing()
    {
        using var rig = new FusionRig();
        Confirm(rig);
        var nan = GeodeticPosition.FromRadians(double.NaN, 0, 0);
        rig.Push(new CameraObservation { SourceSystemId = 1, Number = 1000, TopLeft = nan });
        rig.Push(new CameraObservation { SourceSystemId = 1, Number = 1001, Time = TimeSpan.FromHours(99) });
        rig.Push(
            new CameraObservation
            {
                SourceSystemId = 1,
                Number = 1002,
                TopLeft = Origin,
                TopRight = Origin,
                BottomLeft = Origin,
                BottomRight = Origin
            });
        rig.Run(2);
        Assert.Equal((2L, 0), (rig.Counters.ObservationsRefused, rig.Only.Misses));
    }

    [Fact]
    public void Report_FarAwayBeforeAnythingIsConfirmed_MovesTheFrame()
    {
        using var rig = new FusionRig();
        TargetReport wrong = Report(0, 0);
        wrong.Position = GeodeticPosition.FromRadians(0, 0, 0);
        (wrong.SourceSystemId, wrong.PictureNumber, wrong.Time) = (2, 1, rig.Now);
        rig.Push(wrong);
        rig.Run(1);
        Confirm(rig);
        Assert.Equal(TrackState.Confirmed, rig.Only.State);
        wrong.PictureNumber = 2;
        rig.Push(wrong);
        rig.Run(1);
        Assert.Single(rig.Tracks);
        Assert.Equal(1, rig.Counters.ReportsRefused);
    }

    private static void Confirm(FusionRig rig)
    {
        for (int i = 0; i < 3; i++)
            rig.Observe(0, 0, Report(0, 0));
        Assert.Equal(TrackState.Confirmed, rig.Only.State);
    }

    private static string Describe(TargetTrack t)
        => FormattableString.Invariant(
            $"{t.Id} {t.State} {t.Position.Latitude.Radians:R} {t.Position.Longitude.Radians:R} {t.Covariance.NorthNorth:R} {t.Reports} {t.Misses}");

    private static IEnumerable<TargetReport> HostileReports(TimeSpan now)
    {
        TargetReport Valid()
        {
            TargetReport report = Report(0, 0);
            (report.SourceSystemId, report.Time) = (2, now);
            return report;
        }

        TargetReport With(Func<TargetReport, TargetReport> change) => change(Valid());
        yield return With(r => { r.Position = GeodeticPosition.FromRadians(double.NaN, 0, 0); return r; });
        yield return With(
            r => { r.Position = GeodeticPosition.FromRadians(0.8, double.PositiveInfinity, 0); return r; });
        yield return With(r => { r.Position = GeodeticPosition.FromRadians(9, 0, 0); return r; });
        yield return With(r => { r.Position = GeodeticPosition.FromRadians(0.8, 0.15, 1e9); return r; });
        yield return With(r => { r.Covariance = new HorizontalCovariance(double.NaN, 0, 1); return r; });
        yield return With(r => { r.Covariance = new HorizontalCovariance(1, 2, 1); return r; });
        yield return With(r => { r.Covariance = new HorizontalCovariance(1, 1, 1); return r; });
        yield return With(r => { r.Covariance = new HorizontalCovariance(-1, 0, -1); return r; });
        yield return With(r => { r.Covariance = new HorizontalCovariance(0, 0, 0); return r; });
        yield return With(r => { r.Covariance = new HorizontalCovariance(1e12, 0, 1); return r; });
        yield return With(r => { r.SystematicCovariance = new HorizontalCovariance(double.NaN, 0, 1); return r; });
        yield return With(r => { r.SystematicCovariance = new HorizontalCovariance(1, 5, 1); return r; });
        yield return With(r => { r.Class = TargetClassName.None; return r; });
        yield return With(r => { r.Score = double.NaN; return r; });
        yield return With(r => { r.SizeMetres = double.NaN; return r; });
        yield return With(r => { r.SizeMetres = 1e6; return r; });
        yield return With(r => { r.Index = -1; return r; });
        yield return With(r => { r.PictureNumber = -5; return r; });
        yield return With(r => { r.SourceSystemId = 0; return r; });
        yield return With(r => { r.Time = now + TimeSpan.FromHours(1); return r; });
        yield return With(r => { r.Time = TimeSpan.FromHours(-1); return r; });
        yield return With(r => { r.Position = GeodeticPosition.FromRadians(-0.8, 0.15, 0); return r; });
    }
}
