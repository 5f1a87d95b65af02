using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.SensorFusion;
using Rabit.Uav.SensorFusion.Metrics;
using Rabit.Uav.SensorFusion.Moving;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.SensorFusion.Moving;

/// <summary>
/// Two vehicles see four targets, each in a frame of its own that is some metres off; what B sees arrives at A up to
/// 3 s late, in any order, some of it twice, 30 % never. Which point is of which target is not known.
/// </summary>
public class TwoVehicleTests(ITestOutputHelper output)
{
    private static readonly HorizontalCovariance Registration = new(4, 0, 4);

    [Fact]
    public void Update_TwoVehicles_IsWithinItsLimits()
    {
        var results = new List<Result>();
        foreach (string line in TrackingRun.Lines("two-uav.jsonl.gz"))
        {
            using JsonDocument scenario = JsonDocument.Parse(line);
            results.Add(Run(scenario.RootElement));
        }

        (double error, double inFrame, double nees) =
            (results.Average(r => r.Error), results.Average(r => r.ErrorInFrameOfA), results.Average(r => r.Nees));
        output.WriteLine(FormattableString.Invariant(
            $"position RMSE {error:0.00} m, in the frame of A {inFrame:0.00} m, ANEES of 4: {nees:0.00}"));
        Assert.Equal(10, results.Count);
        Assert.All(results, r => Assert.Equal(360, r.Pairs));
        Assert.InRange(error, 0, 5.7);
        Assert.InRange(inFrame, 0, 5.3);
        Assert.InRange(nees, 3.2, 5.0);
    }

    [Fact]
    public void Update_EveryReportAHundredTimes_ChangesNothing()
    {
        using JsonDocument scenario = JsonDocument.Parse(TrackingRun.Lines("two-uav.jsonl.gz").First());
        Assert.Equal(Run(scenario.RootElement), Run(scenario.RootElement, times: 100));
    }

    private static Result Run(JsonElement scenario, int times = 1)
    {
        int id = 0;
        var tracker = new MovingTracker(
            new TrackerSettings(), [MotionModel.ConstantVelocity(0.1, 3)], () => ++id);
        JsonElement[] reports = scenario.GetProperty("reports").EnumerateArray().ToArray();
        (double Time, int Report)[] arrivals = ArrivalsAtA(scenario, reports);
        double[] bias = Numbers(scenario.GetProperty("bias").GetProperty("A"));
        var seen = new SeenReports(4096);
        var result = new Result();
        int next = 0;
        for (int second = 10; second < 100; second++)
        {
            for (; next < arrivals.Length && arrivals[next].Time <= second; next++)
            {
                for (int i = 0; i < times; i++)
                    Take(tracker, seen, reports[arrivals[next].Report]);
            }

            result = Score(result, tracker, TruthAt(scenario, second), second, bias);
        }

        return result with
        {
            Error = Math.Sqrt(result.Error / result.Pairs),
            ErrorInFrameOfA = Math.Sqrt(result.ErrorInFrameOfA / result.Pairs),
            Nees = result.Nees / result.Pairs,
        };
    }

    private static void Take(MovingTracker tracker, SeenReports seen, JsonElement report)
    {
        byte source = (byte)(report.GetProperty("uav").GetString() == "A" ? 1 : 2);
        long number = report.GetProperty("seq").GetInt64();
        if (!seen.Add(new ReportKey(source, number, 0)))
            return;
        TimeSpan time = Seconds(report.GetProperty("t").GetDouble());
        JsonElement[] r = report.GetProperty("R").EnumerateArray().ToArray();
        ScanPoint[] points = report.GetProperty("z").EnumerateArray().Select((z, i) => new ScanPoint(
            new TrackMeasurement(
                new ReportKey(source, number, i),
                time,
                z[0].GetDouble(),
                z[1].GetDouble(),
                new HorizontalCovariance(r[i][0].GetDouble(), r[i][1].GetDouble(), r[i][2].GetDouble()),
                Registration),
            0,
            -1)).ToArray();
        tracker.Update(new Scan(time, source, 0.9) { AreaSquareMetres = 1e6, ShowsAll = true }, points);
    }

    // Each target with the nearest track: they are hundreds of metres apart most of the time.
    private static Result Score(Result sum, MovingTracker tracker, double[][] truth, int second, double[] bias)
    {
        var there = new MotionFilter();
        double[] p = new double[16];
        foreach (double[] target in truth)
        {
            double nearest = 50 * 50;
            Result best = sum;
            foreach (MovingTrack track in tracker.Tracks.Where(t => t.IsConfirmed))
            {
                track.Filter.PredictTo(TimeSpan.FromSeconds(second), there);
                (double north, double east) = (there.North - target[0], there.East - target[2]);
                if ((north * north) + (east * east) >= nearest)
                    continue;
                nearest = (north * north) + (east * east);
                there.CopyCovarianceTo(p);
                (double inNorth, double inEast) = (north - bias[0], east - bias[1]);
                best = new Result(
                    sum.Pairs + 1,
                    sum.Error + nearest,
                    sum.ErrorInFrameOfA + (inNorth * inNorth) + (inEast * inEast),
                    sum.Nees + TrackingMetrics.Nees(
                        [north, there.NorthRate - target[1], east, there.EastRate - target[3]],
                        [p[0], p[1], p[2], p[3], p[5], p[6], p[7], p[10], p[11], p[15]]));
            }

            sum = best;
        }

        return sum;
    }

    // A's own at once, those of B when they arrive.
    private static (double Time, int Report)[] ArrivalsAtA(JsonElement scenario, JsonElement[] reports)
    {
        IEnumerable<(double, int)> own = reports.Where(r => r.GetProperty("uav").GetString() == "A")
            .Select(r => (r.GetProperty("t").GetDouble(), r.GetProperty("id").GetInt32()));
        IEnumerable<(double, int)> received = scenario.GetProperty("link_b_to_a").EnumerateArray()
            .Select(a => (a[0].GetDouble(), a[1].GetInt32()));
        return own.Concat(received).OrderBy(a => a).ToArray();
    }

    private static double[][] TruthAt(JsonElement scenario, int second)
    {
        List<double> times = scenario.GetProperty("truth_t").EnumerateArray().Select(t => t.GetDouble()).ToList();
        int index = times.IndexOf(second);
        return scenario.GetProperty("truth")[index].EnumerateArray().Select(Numbers).ToArray();
    }

    private static double[] Numbers(JsonElement array) => array.EnumerateArray().Select(n => n.GetDouble()).ToArray();

    private static TimeSpan Seconds(double seconds)
        => TimeSpan.FromTicks((long)Math.Round(seconds * TimeSpan.TicksPerSecond));

    private readonly record struct Result(int Pairs, double Error, double ErrorInFrameOfA, double Nees);
}
