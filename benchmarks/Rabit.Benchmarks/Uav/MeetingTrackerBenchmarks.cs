using System;
using System.Collections.Generic;
using BenchmarkDotNet.Attributes;
using Rabit.Geodesy;
using Rabit.Uav.SensorFusion;
using Rabit.Uav.SensorFusion.Moving;

namespace Rabit.Benchmarks.Uav;

/// <summary>
/// A scan of targets of one class that meet: two that cross within 3 m every minute, the mean over ten minutes; or
/// some that walk side by side, 2 m apart, so that each is within the gates of its neighbours in every scan.
/// </summary>
[MemoryDiagnoser]
public class MeetingTrackerBenchmarks
{
    private const int Scans = 1200;
    private const double Sigma = 0.7;

    private static readonly HorizontalCovariance Noise = new(Sigma * Sigma, 0, Sigma * Sigma);
    private static readonly HorizontalCovariance Registration = new(0.25, 0, 0.25);

    private readonly ScanPoint[][] _crossing = new ScanPoint[Scans][];
    private readonly ScanPoint[][] _twoAbreast = new ScanPoint[Scans][];
    private readonly ScanPoint[][] _fiveAbreast = new ScanPoint[Scans][];
    private readonly Random _random = new(1);
    private MovingTracker _tracker = null!;

    [GlobalSetup]
    public void Make()
    {
        for (int i = 0; i < Scans; i++)
        {
            // 40 m and back in a minute, at right angles, with their ends where they turn.
            double way = 1 - (Math.Abs((i % 120) - 60) / 60.0);
            double along = (40 * way) - 20;
            _crossing[i] = Points(i, (along, 1), (1, along));
            _twoAbreast[i] = Points(i, (0.5 * i, 0), (0.5 * i, 2));
            _fiveAbreast[i] = Points(i, (0.5 * i, 0), (0.5 * i, 2), (0.5 * i, 4), (0.5 * i, 6), (0.5 * i, 8));
        }

        int id = 0;
        _tracker = new MovingTracker(new TrackerSettings(), [MotionModel.Walking], () => ++id);
        (int crossing, int two, int five) = (TwoThatCross(), TwoAbreast(), FiveAbreast());
        if (crossing != 2 || two != 2 || five != 5)
            throw new InvalidOperationException($"Tracks: {crossing} of 2, {two} of 2, {five} of 5.");
    }

    [Benchmark(OperationsPerInvoke = Scans)]
    public int TwoThatCross() => Track(_crossing);

    [Benchmark(OperationsPerInvoke = Scans)]
    public int TwoAbreast() => Track(_twoAbreast);

    [Benchmark(OperationsPerInvoke = Scans)]
    public int FiveAbreast() => Track(_fiveAbreast);

    private int Track(ScanPoint[][] scans)
    {
        _tracker.Clear();
        for (int i = 0; i < Scans; i++)
        {
            var scan = new Scan(TimeOf(i), 1, 0.9) { AreaSquareMetres = 1e4, ShowsAll = true };
            _tracker.Update(scan, scans[i]);
        }

        int confirmed = 0;
        foreach (MovingTrack track in _tracker.Tracks)
            confirmed += track.IsConfirmed ? 1 : 0;
        return confirmed;
    }

    // Each is reported with 90 %.
    private ScanPoint[] Points(int scan, params (double North, double East)[] places)
    {
        var points = new List<ScanPoint>();
        foreach ((double north, double east) in places)
        {
            if (_random.NextDouble() >= 0.9)
                continue;
            var key = new ReportKey(1, scan, points.Count);
            var measurement = new TrackMeasurement(
                key, TimeOf(scan), north + Error(), east + Error(), Noise, Registration);
            points.Add(new ScanPoint(measurement, 0, -1));
        }

        return [.. points];
    }

    private static TimeSpan TimeOf(int scan) => TimeSpan.FromMilliseconds(500 * scan);

    // Of the sigma, as twelve uniform numbers.
    private double Error()
    {
        double sum = -6;
        for (int i = 0; i < 12; i++)
            sum += _random.NextDouble();
        return Sigma * sum;
    }
}
