using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.SensorFusion;
using Rabit.Uav.SensorFusion.Metrics;
using Rabit.Uav.SensorFusion.Moving;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.SensorFusion.Moving;

public class MovingTrackerTests(ITestOutputHelper output)
{
    private const int Walkers = 0;
    private const int Vehicles = 1;

    private static readonly MotionModel[] Models = [MotionModel.Walking, MotionModel.Vehicle];

    private readonly TrackerSettings _settings = new();
    private int _lastId;
    private long _picture;

    [Fact]
    public void Update_ThreePointsInARow_ConfirmATarget()
    {
        MovingTracker tracker = Tracker();
        for (int i = 0; i < 3; i++)
        {
            Assert.Empty(Confirmed(tracker));
            Look(tracker, i, (i, 0, Walkers, -1));
        }

        MovingTrack track = Assert.Single(Confirmed(tracker));
        Assert.Equal(3, track.Points);
        Assert.InRange(track.Existence, 0.99, 1);
    }

    [Fact]
    public void Update_MissedInEveryLook_IsDeleted()
    {
        MovingTracker tracker = Tracker();
        for (int i = 0; i < 6; i++)
            Look(tracker, i, (i, 0, Walkers, -1));
        int looks = 0;
        while (tracker.Tracks.Count > 0 && looks < 100)
            Look(tracker, 6 + looks++);
        Assert.InRange(looks, 3, 12);
        Assert.Equal(1, tracker.TracksDeleted);
    }

    [Fact]
    public void Update_LooksThatDoNotShowIt_AreNoMisses()
    {
        MovingTracker tracker = Tracker();
        for (int i = 0; i < 6; i++)
            Look(tracker, i, (i, 0, Walkers, -1));
        for (int i = 6; i < 20; i++)
            tracker.Update(new Scan(TimeSpan.FromSeconds(i), 1, 0.9), []);
        Assert.Single(Confirmed(tracker));
        Assert.Equal(0, tracker.Tracks[0].Misses);
    }

    [Fact]
    public void Update_NotSeenForLong_IsDeletedWhenItMayBeAnywhere()
    {
        MovingTracker tracker = Tracker();
        for (int i = 0; i < 6; i++)
            Look(tracker, i, (i, 0, Walkers, -1));
        int second = 6;
        while (tracker.Tracks.Count > 0 && second < 3600)
            tracker.Update(new Scan(TimeSpan.FromSeconds(second++), 1, 0.9), []);
        output.WriteLine($"a walker is kept for {second - 6} s");
        Assert.InRange(second, 30, 900);
    }

    [Fact]
    public void Update_NewTargetAfterOneThatMayBeAnywhere_IsTracked()
    {
        MovingTracker tracker = Tracker();
        for (int i = 0; i < 6; i++)
            Look(tracker, i, (i, 0, Walkers, -1));
        int second = 6;
        while (tracker.Tracks.Count > 0)
            tracker.Update(new Scan(TimeSpan.FromSeconds(second++), 1, 0.9), []);
        for (int i = 0; i < 8; i++)
            Look(tracker, second + i, (i, 40, Walkers, -1));
        Assert.Equal(8, Assert.Single(Confirmed(tracker)).Points);
        Assert.Equal(2, tracker.TracksStarted);
    }

    [Theory]
    [InlineData(25, 1)]
    [InlineData(120, 2)]
    public void Update_TargetSeenWhileAnotherIsHidden_IsTheSameOnlyWhereThatMayBe(double metresAway, int id)
    {
        MovingTracker tracker = Tracker();
        for (int i = 0; i < 12; i++)
            Look(tracker, i, (i, 0, Walkers, -1));
        for (int i = 12; i < 27; i++)
            Look(tracker, i);
        Assert.True(Assert.Single(tracker.Tracks).IsOccluded);
        for (int i = 0; i < 4; i++)
            Look(tracker, 27 + i, (27 + i, metresAway, Walkers, -1));

        MovingTrack seen = Assert.Single(Confirmed(tracker), t => !t.IsOccluded);
        Assert.Equal(id, seen.Id);
        Assert.Equal(id == 1 ? 16 : 4, seen.Points);
        Assert.Equal(id == 1 ? 1 : 0, tracker.TracksFoundAgain);
        Assert.Equal(1, tracker.TracksOccluded);
        Assert.Equal(0, tracker.TracksDeleted);
    }

    [Fact]
    public void Update_TwoClassesAtOnePlace_AreTwoTracks()
    {
        MovingTracker tracker = Tracker();
        for (int i = 0; i < 6; i++)
            Look(tracker, i, (i, 0, Walkers, -1), (i, 0.5, Vehicles, -1));
        Assert.Equal([Walkers, Vehicles], Confirmed(tracker).Select(t => t.Class).OrderBy(c => c));
    }

    [Fact]
    public void Update_MarkersThatCross_KeepTheirTracks()
    {
        MovingTracker tracker = Tracker();
        for (int i = 0; i < 30; i++)
            Look(tracker, i, (i, 15 - i, Walkers, 7), (i, i - 15, Walkers, 8));
        Assert.Equal([7, 8], Confirmed(tracker).Select(t => t.Marker).OrderBy(m => m));
        MovingTrack seven = Confirmed(tracker).Single(t => t.Marker == 7);
        Assert.Equal(30, seven.Points);
        Assert.InRange(seven.Filter.Current.East, -16, -12);
    }

    [Theory]
    [InlineData(Walkers, 1.4)]
    [InlineData(Vehicles, 10)]
    public void Update_StopsAndStarts_KeepsItsTrack(int ofClass, double speed)
    {
        const int Seed = 3;
        var random = new SeededNumbers(Seed);
        MovingTracker tracker = Tracker();
        (double place, double velocity) = (0, 0);
        var errors = new List<double>();
        for (int i = 0; i < 600; i++)
        {
            // It brakes and starts with 3 m/s2.
            double wanted = i / 60 % 2 == 0 ? speed : 0;
            velocity += Math.Max(-1.5, Math.Min(1.5, wanted - velocity));
            place += 0.5 * velocity;
            Look(tracker, 0.5 * i, (place + random.Gauss(), random.Gauss(), ofClass, -1));
            if (i > 10)
                errors.Add(Math.Abs(Confirmed(tracker)[0].Filter.Current.North - place));
        }

        output.WriteLine(FormattableString.Invariant(
            $"class {ofClass}, seed {Seed}: worst {errors.Max():0.00} m, mean {errors.Average():0.00} m"));
        MovingTrack track = Assert.Single(Confirmed(tracker));
        Assert.Equal(600, track.Points);
        Assert.InRange(errors.Max(), 0, 5);
    }

    [Theory]
    [InlineData(18, 1)]
    [InlineData(30, 1)]
    [InlineData(18, 3)]
    public void Update_VehicleThatTurns_HasAnHonestCovariance(double degreesPerSecond, double sigma)
    {
        const int Seed = 20;
        const int Runs = 20;
        var random = new SeededNumbers(Seed);
        (double squares, double nees, int count) = (0, 0, 0);
        double[] p = new double[16];
        for (int run = 0; run < Runs; run++)
        {
            MovingTracker tracker = Tracker();
            (double north, double east, double heading) = (0, 0, random.Uniform(0, 6));
            for (int i = 0; i < 240; i++)
            {
                // 8 m/s; 15 s straight on, then a right angle.
                double time = 0.5 * i;
                bool isTurning = time % (15 + (90 / degreesPerSecond)) > 15;
                heading += isTurning ? 0.5 * degreesPerSecond * Math.PI / 180 : 0;
                north += 4 * Math.Cos(heading);
                east += 4 * Math.Sin(heading);
                bool isSeen = random.Uniform(0, 1) < 0.9;
                (double, double, int, int)[] points = isSeen
                    ? [(north + (sigma * random.Gauss()), east + (sigma * random.Gauss()), Vehicles, -1)]
                    : [];
                Look(tracker, time, sigma, points);
                if (i < 20)
                    continue;
                MovingTrack track = Assert.Single(Confirmed(tracker));
                var there = new MotionFilter();
                track.Filter.PredictTo(tracker.Time, there);
                there.CopyCovarianceTo(p);
                (double n, double e) = (there.North - north, there.East - east);
                squares += (n * n) + (e * e);
                nees += TrackingMetrics.Nees(n, e, new HorizontalCovariance(p[0], p[2], p[10]));
                count++;
            }
        }

        double error = Math.Sqrt(squares / count);
        nees /= count;
        output.WriteLine(FormattableString.Invariant(
            $"seed {Seed}, {degreesPerSecond} deg/s, sigma {sigma} m: RMSE {error:0.00} m, NEES {nees:0.00} of 2"));
        Assert.InRange(error, 0, 4);
        Assert.InRange(nees, 1.4, 2.6);
    }

    [Fact]
    public void Update_TwoThatCrossEveryMinute_AreHardlyExchanged()
    {
        const int Seed = 5;
        var random = new SeededNumbers(Seed);
        MovingTracker tracker = Tracker();
        var metrics = new ClearMotMetrics(20);
        for (int i = 0; i < 1200; i++)
        {
            // 80 m apart at most, 2 m at the least, once a minute.
            double time = 0.5 * i;
            double north = 40 * Math.Cos(Math.PI * time / 60);
            NedPosition[] truth = [new(north, 1, 0), new(-north, -1, 0)];
            Look(tracker, time, truth.Where(_ => random.Uniform(0, 1) < 0.9)
                .Select(t => (t.North + random.Gauss(), t.East + random.Gauss(), Walkers, -1)).ToArray());
            MovingTrack[] tracks = Confirmed(tracker);
            metrics.Add(
                [1, 2],
                truth,
                tracks.Select(t => t.Id).ToArray(),
                tracks.Select(t => PlaceOf(t, tracker.Time)).ToArray());
        }

        output.WriteLine($"seed {Seed}: {metrics.IdSwitches} switches, MOTA {metrics.Mota:0.000}");
        Assert.InRange(metrics.IdSwitches, 0, 1);
        Assert.InRange(metrics.Mota, 0.97, 1);
    }

    [Fact]
    public void Update_AThousandClutterPointsAScan_KeepsTheTargetAndCountsTheRest()
    {
        const int Seed = 9;
        var random = new SeededNumbers(Seed);
        MovingTracker tracker = Tracker();
        for (int i = 0; i < 20; i++)
            Look(tracker, i, (i, 0, Walkers, -1));
        long points = 20;
        for (int i = 20; i < 60; i++)
        {
            var all = new (double, double, int, int)[1001];
            all[0] = (i, 0, Walkers, -1);
            for (int c = 1; c < all.Length; c++)
                all[c] = (random.Uniform(-500, 500), random.Uniform(-500, 500), Walkers, -1);
            Look(tracker, i, all);
            points += all.Length;
            Assert.InRange(tracker.Tracks.Count, 1, _settings.MaxTracks);
        }

        MovingTrack track = Confirmed(tracker).Single(t => t.Id == 1);
        Assert.InRange(PlaceOf(track, tracker.Time).North, 54, 64);
        output.WriteLine($"seed {Seed}: {tracker.PointsWithoutRoom} of {points} without room, "
            + $"{Confirmed(tracker).Length} confirmed, clutter {tracker.ClutterDensity(Walkers):g2}");
        Assert.Equal(
            points, tracker.PointsUsed + tracker.TracksStarted + tracker.PointsWithoutRoom + tracker.PointsLate);
        Assert.InRange(tracker.PointsWithoutRoom, 10_000, points);

        // Nothing of it stays.
        for (int i = 60; i < 75; i++)
            Look(tracker, i, (i, 0, Walkers, -1));
        Assert.Equal(1, Assert.Single(tracker.Tracks).Id);
    }

    [Fact]
    public void Update_ScansLateAndInAnyOrder_IsNearlyAsInOrder()
    {
        MovingTracker inOrder = Tracker();
        MovingTracker late = Tracker();
        int[] order = Enumerable.Range(0, 40).ToArray();
        for (int i = 6; i + 3 < order.Length; i += 4)
            (order[i], order[i + 3]) = (order[i + 3], order[i]);
        for (int i = 0; i < order.Length; i++)
        {
            Look(inOrder, i, (2 * i, i, Vehicles, -1));
            Look(late, order[i], (2 * order[i], order[i], Vehicles, -1));
        }

        MovingTrack expected = Assert.Single(Confirmed(inOrder));
        MovingTrack actual = Assert.Single(Confirmed(late));
        Assert.Equal(40, actual.Points);
        Assert.Equal(PlaceOf(expected, inOrder.Time), PlaceOf(actual, late.Time));
    }

    [Fact]
    public void Update_OlderThanTheWindow_IsCountedAndChangesNothing()
    {
        MovingTracker tracker = Tracker();
        for (int i = 0; i < 20; i++)
            Look(tracker, i, (i, 0, Walkers, -1));
        Look(tracker, 5, (5, 0, Walkers, -1), (100, 0, Walkers, -1));
        Assert.Equal(2, tracker.PointsLate);
        Assert.Single(tracker.Tracks);
        Assert.Equal(20, tracker.Tracks[0].Points);
    }

    // Of a row of targets each is near its three neighbours on each side.
    [Theory]
    [InlineData(8, false)]
    [InlineData(30, true)]
    public void Update_MoreMeetThanThereIsRoomFor_AreCounted(int targets, bool areMore)
    {
        MovingTracker tracker = Tracker();
        for (int i = 0; i < 12; i++)
            Look(tracker, i, Enumerable.Range(0, targets).Select(t => (2.0 * t, 0.0, Walkers, -1)).ToArray());

        Assert.Equal(targets, Confirmed(tracker).Length);
        Assert.Equal(areMore, tracker.Meetings.WithoutRoom > 0);
    }

    private static NedPosition PlaceOf(MovingTrack track, TimeSpan time)
    {
        var there = new MotionFilter();
        track.Filter.PredictTo(time, there);
        return new NedPosition(there.North, there.East, 0);
    }

    private static MovingTrack[] Confirmed(MovingTracker tracker) => tracker.Tracks.Where(t => t.IsConfirmed).ToArray();

    private MovingTracker Tracker() => new(_settings, Models, () => ++_lastId);

    private void Look(MovingTracker tracker, double second, params (double N, double E, int Class, int Marker)[] points)
        => Look(tracker, second, 1, points);

    private void Look(
        MovingTracker tracker, double second, double sigma, (double N, double E, int Class, int Marker)[] points)
    {
        var covariance = new HorizontalCovariance(sigma * sigma, 0, sigma * sigma);
        TimeSpan time = TimeSpan.FromTicks((long)(second * TimeSpan.TicksPerSecond));
        _picture++;
        ScanPoint[] all = points.Select((p, i) => new ScanPoint(
            new TrackMeasurement(
                new ReportKey(1, _picture, i), time, p.N, p.E, covariance, default),
            p.Class,
            p.Marker)).ToArray();
        tracker.Update(new Scan(time, 1, 0.9) { AreaSquareMetres = 1e6, ShowsAll = true }, all);
    }
}
