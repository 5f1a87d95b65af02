using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.Messages;
using Rabit.Uav.SensorFusion;
using Rabit.Uav.SensorFusion.Moving;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.SensorFusion.Moving;

/// <summary>
/// A track is fused with what another vehicle knows of its target: what the frames of all are off, 2 m per axis, is
/// still in it.
/// </summary>
public class FusedRegistrationTests(ITestOutputHelper output)
{
    private const int Runs = 300;
    private const int LaterReports = 20;

    private const double Sigma = 0.5;

    private static readonly HorizontalCovariance Registration = new(4, 0, 4);
    private static readonly HorizontalCovariance Noise = new(Sigma * Sigma, 0, Sigma * Sigma);

    // The other vehicle has gone on where we saw nothing for a while; a state of ours may be worth little, then.
    [Theory]
    [InlineData(3)]
    [InlineData(8)]
    [InlineData(20)]
    public void TryFuse_ThenHundredOwnReports_IsNoSurerThanTheOwnFrame(int gapSeconds)
    {
        (MovingTrack ours, MovingTrack theirs) = (Track(), Track());
        double time = 0;
        for (int i = 0; i < 20; i++, time += 0.5)
        {
            Take(ours, 1, time, time, 0);
            Take(theirs, 2, time, time, 0);
        }

        for (int i = 0; i < 2 * gapSeconds; i++, time += 0.5)
            Take(theirs, 2, time, time, 0);
        Fuse(ours, theirs, 2);
        double fused = MinVariance(ours);
        double least = double.PositiveInfinity;
        for (int i = 0; i < 100; i++, time += 0.5)
        {
            Take(ours, 1, time, time, 0);
            least = Math.Min(least, MinVariance(ours));
        }

        output.WriteLine(FormattableString.Invariant($"{fused:0.00} m2 fused, then at least {least:0.00} m2"));
        Assert.InRange(least, 3.9, 5);
    }

    // What the other vehicle's state was made of: of its own reports, of those of all three, or of those of a third
    // one, whose further reports we have, too.
    [Theory]
    [InlineData(new byte[] { 1 }, new byte[] { 2 }, 1, 0.5)]
    [InlineData(new byte[] { 1 }, new byte[] { 1, 2 }, 1, 0.5)]
    [InlineData(new byte[] { 1, 3 }, new byte[] { 1, 2, 3 }, 1, 0.5)]
    [InlineData(new byte[] { 1, 3 }, new byte[] { 3 }, 3, 1.2)]
    public void TryFuse_AStateOfAnyReports_IsConsistent(byte[] ofOurs, byte[] ofTheirs, byte later, double leastNees)
    {
        double[] sums = new double[LaterReports];
        for (int seed = 1; seed <= Runs; seed++)
            AddNees(new SeededNumbers(seed), ofOurs, ofTheirs, later, sums);
        string means = string.Join(" ", sums.Select(s => FormattableString.Invariant($"{s / Runs:0.00}")));
        output.WriteLine($"NEES of 2 after each report, mean of seeds 1 to {Runs}: {means}");

        // 99.9 % of a consistent one; covariance intersection may well be too careful.
        Assert.InRange(sums.Max() / Runs, leastNees, 2.4);
    }

    private static void AddNees(
        SeededNumbers random, byte[] ofOurs, byte[] ofTheirs, byte later, double[] sums)
    {
        (MovingTrack ours, MovingTrack theirs) = (Track(), Track());
        double[] off = [.. Enumerable.Range(0, 8).Select(_ => 2 * random.Gauss())];
        (double north, double northRate, double east, double eastRate) = (0, random.Gauss(), 0, random.Gauss());
        for (int i = 0; i < 40 + LaterReports; i++)
        {
            (northRate, eastRate) = (northRate + (0.2 * random.Gauss()), eastRate + (0.2 * random.Gauss()));
            (north, east) = (north + (0.5 * northRate), east + (0.5 * eastRate));
            if (i == 40)
                Fuse(ours, theirs, 2);

            // Ours is without any report for ten seconds.
            bool isAlone = i is >= 20 and < 40;
            foreach (byte source in i < 40 ? ofOurs.Union(ofTheirs) : [later])
            {
                double n = north + off[2 * source] + (Sigma * random.Gauss());
                double e = east + off[(2 * source) + 1] + (Sigma * random.Gauss());
                if (ofOurs.Contains(source) && !isAlone)
                    Take(ours, source, 0.5 * i, n, e);
                if (ofTheirs.Contains(source) && !(isAlone && source == 1))
                    Take(theirs, source, 0.5 * i, n, e);
            }

            MotionFilter filter = ours.Filter.Current;
            var error = new Innovation(filter.North - north, filter.East - east, filter.PositionCovariance);
            if (i >= 40)
                sums[i - 40] += error.DistanceSquared;
        }
    }

    private static MovingTrack Track() => new(new TrackerSettings());

    private static void Take(MovingTrack track, byte source, double seconds, double north, double east)
    {
        TimeSpan time = TimeSpan.FromMilliseconds(1000 * seconds);
        var key = new ReportKey(source, (long)(2 * seconds), 0);
        var measurement = new TrackMeasurement(key, time, north, east, Noise, Registration);
        if (track.Id == 0)
            track.Start(1, new ScanPoint(measurement, 0, -1), MotionModel.Walking, 0.5);
        else
            Assert.Equal(TakeResult.Used, track.Filter.Take(measurement));
    }

    private static void Fuse(MovingTrack ours, MovingTrack theirs, byte source)
    {
        MotionFilter filter = theirs.Filter.Current;
        double[] p = new double[16];
        filter.CopyCovarianceTo(p);
        var sent = new TrackEstimate
        {
            SourceSystemId = source,
            Time = theirs.LastSeen,
            VelocityNed = new NedVector(filter.NorthRate, filter.EastRate, 0),
            Covariance = new HorizontalCovariance(p[0], p[2], p[10]),
            VelocityCovariance = new HorizontalCovariance(p[5], p[7], p[15]),
            NorthWithNorthRate = p[1],
            NorthWithEastRate = p[3],
            EastWithNorthRate = p[6],
            EastWithEastRate = p[11],
        };
        var estimate = new ForeignEstimate();
        estimate.Set(sent, new NedPosition(filter.North, filter.East, 0), 0, Registration);
        Assert.True(new EstimateFusion().TryFuse(ours, estimate, MotionModel.Walking));
    }

    private static double MinVariance(MovingTrack track)
    {
        HorizontalCovariance c = track.Filter.Current.PositionCovariance;
        return Math.Min(c.NorthNorth, c.EastEast);
    }
}
