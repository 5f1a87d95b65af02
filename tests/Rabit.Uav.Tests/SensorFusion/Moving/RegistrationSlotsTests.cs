using System;
using Rabit.Geodesy;
using Rabit.Uav.SensorFusion;
using Rabit.Uav.SensorFusion.Moving;
using Xunit;

namespace Rabit.Uav.Tests.SensorFusion.Moving;

/// <summary>Only the sources of points that are of a track take its slots, not of those that were tried.</summary>
public class RegistrationSlotsTests
{
    private static readonly TrackerSettings Settings = new();
    private static readonly HorizontalCovariance Unit = new(1, 0, 1);

    [Fact]
    public void Find_TracksThatAreNotOfOneTarget_TakeNoSlots()
    {
        var earlier = new MovingTrack(Settings);
        earlier.Start(1, Point(1, 0, 0), MotionModel.Walking, 0.5);
        for (int i = 1; i < 20; i++)
            Look(earlier, i, Point(1, i, 0));
        for (int i = 20; !earlier.IsOccluded && i < 60; i++)
            Look(earlier, i, null);
        Assert.True(earlier.IsOccluded);

        var later = new MovingTrack(Settings);
        later.Start(2, Point(2, 60, 500), MotionModel.Walking, 0.5);
        Assert.Null(new TrackStitcher(Settings).Find([earlier, later], later));

        Assert.Equal((1, -1), (earlier.Filter.Slots.Count, earlier.Filter.Slots.Find(2)));
        Assert.Equal((1, -1), (later.Filter.Slots.Count, later.Filter.Slots.Find(1)));
    }

    [Fact]
    public void Resolve_TracksThatKeepTheirPoints_TakeNoSlots()
    {
        (OutOfSequenceFilter first, OutOfSequenceFilter second) = (Filter(), Filter());
        for (int i = 0; i < 40; i++)
        {
            first.Take(Point(1, i, 0).Measurement);
            second.Take(Point(2, i, 20).Measurement);
        }

        Assert.True(first.Before.IsStarted && second.Before.IsStarted);
        var resolver = new MeetingResolver(Settings.KeptPoints, Settings.ExchangeMargin);
        Assert.False(resolver.Resolve(first, second, MotionModel.Walking));

        Assert.Equal((1, -1), (first.Slots.Count, first.Slots.Find(2)));
        Assert.Equal((1, -1), (second.Slots.Count, second.Slots.Find(1)));
    }

    private static OutOfSequenceFilter Filter()
    {
        var filter = new OutOfSequenceFilter(Settings.Window, Settings.KeptPoints);
        filter.Start(MotionModel.Walking);
        return filter;
    }

    private static void Look(MovingTrack track, int second, ScanPoint? point)
    {
        var scan = new Scan(TimeSpan.FromSeconds(second), 1, 0.9) { ShowsAll = true };
        track.Expect(scan, Unit, new ExistenceStep(Settings, 1));
        if (point is { } seen)
            track.Hit(seen, 1000);
        else
            track.Miss();
    }

    private static ScanPoint Point(byte source, int second, double east)
        => new(
            new TrackMeasurement(
                new ReportKey(source, second, 0), TimeSpan.FromSeconds(second), second, east, Unit, Unit),
            0,
            -1);
}
