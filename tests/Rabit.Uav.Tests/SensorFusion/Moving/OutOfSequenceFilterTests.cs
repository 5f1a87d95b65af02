using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.SensorFusion;
using Rabit.Uav.SensorFusion.Moving;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.SensorFusion.Moving;

/// <summary>Against exact processing in order (tests/data/autonomy/kalman.json) and against itself.</summary>
public class OutOfSequenceFilterTests(ITestOutputHelper output)
{
    private static readonly TimeSpan Window = TimeSpan.FromSeconds(10);

    [Fact]
    public void Take_ReferenceArrivals_IsThatInOrderToOnePartInABillion()
    {
        using JsonDocument data = TestData.Autonomy("kalman.json");
        var results = new Dictionary<string, int>();
        int cases = 0;
        double worst = 0;
        foreach (JsonElement sequence in data.RootElement.GetProperty("oosm").EnumerateArray())
        {
            var filter = new OutOfSequenceFilter(Seconds(sequence, "window_s"), 64);
            filter.Start(
                MotionModel.ConstantVelocity(sequence.GetProperty("q").GetDouble(), 1),
                TimeSpan.Zero,
                Numbers(sequence, "x0"),
                Numbers(sequence, "P0"));
            JsonElement[] after = sequence.GetProperty("after_each").EnumerateArray().ToArray();
            int i = 0;
            foreach (JsonElement arrival in sequence.GetProperty("arrivals").EnumerateArray())
            {
                JsonElement expected = after[i++];
                TakeResult result = filter.Take(Measurement(arrival));
                string action = result switch
                {
                    TakeResult.Used => "used",
                    TakeResult.Duplicate => "duplicate",
                    _ => "too_old",
                };
                Assert.Equal(expected.GetProperty("action").GetString(), action);
                results[action] = results.TryGetValue(action, out int before) ? before + 1 : 1;
                Assert.Equal(Seconds(expected, "t"), filter.Time);
                worst = Math.Max(worst, Difference(Numbers(expected, "x"), State(filter.Current)));
                worst = Math.Max(worst, Difference(Numbers(expected, "P"), UpperTriangle(filter.Current)));
            }

            cases++;
        }

        output.WriteLine($"{cases} cases, {string.Join(", ", results.OrderBy(r => r.Key))}, worst {worst:g2}");
        Assert.Equal(30, cases);
        Assert.Equal(3, results.Count);
        Assert.InRange(worst, 0, 1e-9);
    }

    [Fact]
    public void PredictTo_ReferenceSequences_AgreesToOnePartInABillion()
    {
        using JsonDocument data = TestData.Autonomy("kalman.json");
        int steps = 0;
        double worst = 0;
        foreach (JsonElement sequence in data.RootElement.GetProperty("kf_sequences").EnumerateArray())
        {
            var filter = new OutOfSequenceFilter(Window, 64);
            TimeSpan now = TimeSpan.FromSeconds(100);
            filter.Start(
                MotionModel.ConstantVelocity(sequence.GetProperty("q").GetDouble(), 1),
                now,
                Numbers(sequence, "x0"),
                Numbers(sequence, "P0"));
            var there = new MotionFilter();
            foreach (JsonElement step in sequence.GetProperty("steps").EnumerateArray())
            {
                now += Seconds(step, "dt");
                filter.PredictTo(now, there);
                worst = Math.Max(worst, Difference(Numbers(step, "x_pred"), State(there)));
                worst = Math.Max(worst, Difference(Numbers(step, "P_pred"), UpperTriangle(there)));
                steps++;
                if (!step.TryGetProperty("z", out _))
                    continue;
                TrackMeasurement measurement = Measurement(step, steps, now);
                HorizontalCovariance s = there.Expect(0, -1, default).Covariance + measurement.Covariance;
                var innovation = new Innovation(measurement.North - there.North, measurement.East - there.East, s);
                worst = Math.Max(worst, Difference(Numbers(step, "S"), [s.NorthNorth, s.NorthEast, s.EastEast]));
                worst = Math.Max(worst, Difference(
                    [step.GetProperty("loglik").GetDouble()], [Math.Log(innovation.Likelihood)]));
                Assert.Equal(TakeResult.Used, filter.Take(measurement));
                worst = Math.Max(worst, Difference(Numbers(step, "x"), State(filter.Current)));
                worst = Math.Max(worst, Difference(Numbers(step, "P"), UpperTriangle(filter.Current)));
            }
        }

        output.WriteLine($"{steps} steps, worst {worst:g2}");
        Assert.Equal(600, steps);
        Assert.InRange(worst, 0, 1e-9);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void Take_AnyOrder_IsTheSameToTheLastBit(int modes)
    {
        const int Seed = 11;
        output.WriteLine($"seed {Seed}");
        var random = new SeededNumbers(Seed);
        MotionModel model = modes == 1
            ? MotionModel.ConstantVelocity(0.1, 2)
            : MotionModel.TwoModes(0.05, 3, 5, 0.1, 0.3);
        for (int run = 0; run < 50; run++)
        {
            TrackMeasurement[] ordered = Enumerable.Range(0, 20).Select(i => new TrackMeasurement(
                new ReportKey((byte)(1 + (i % 3)), i, 0),
                TimeSpan.FromMilliseconds(400 * i),
                (3 * i) + random.Gauss(),
                (-2 * i) + random.Gauss(),
                new HorizontalCovariance(2, 0.3, 1),
                new HorizontalCovariance(4, 0, 4))).ToArray();
            OutOfSequenceFilter inOrder = Filtered(model, ordered);

            // The first two stay first, so that the sources have the same slots.
            TrackMeasurement[] shuffled = ordered.Take(3)
                .Concat(ordered.Skip(3).OrderBy(_ => random.Uniform(0, 1))).ToArray();
            OutOfSequenceFilter anyOrder = Filtered(model, shuffled);
            Assert.Equal(inOrder.Time, anyOrder.Time);
            Assert.Equal(State(inOrder.Current), State(anyOrder.Current));
            Assert.Equal(UpperTriangle(inOrder.Current), UpperTriangle(anyOrder.Current));
            Assert.Equal(inOrder.Current.LivelyProbability, anyOrder.Current.LivelyProbability);
        }
    }

    [Fact]
    public void Take_TheVeryFirstArrivesLate_IsTheStart()
    {
        MotionModel model = MotionModel.ConstantVelocity(0.1, 2);
        TrackMeasurement[] three = Enumerable.Range(0, 3).Select(i => Plain(i, i, 10 * i)).ToArray();
        OutOfSequenceFilter filter = Filtered(model, [three[1], three[2], three[0]]);
        Assert.Equal(State(Filtered(model, three).Current), State(filter.Current));
    }

    [Fact]
    public void Take_ReplayedAHundredTimes_ChangesNothing()
    {
        MotionModel model = MotionModel.ConstantVelocity(0.1, 2);
        TrackMeasurement[] five = Enumerable.Range(0, 5).Select(i => Plain(i, i, i)).ToArray();
        OutOfSequenceFilter filter = Filtered(model, five);
        double[] before = UpperTriangle(filter.Current);
        for (int i = 0; i < 100; i++)
            Assert.Equal(TakeResult.Duplicate, filter.Take(five[2]));
        Assert.Equal(before, UpperTriangle(filter.Current));
    }

    [Fact]
    public void Take_MoreThanThereIsRoomFor_ShortensTheWindow()
    {
        var filter = new OutOfSequenceFilter(Window, 4);
        filter.Start(MotionModel.ConstantVelocity(0.1, 2));
        for (int i = 0; i < 8; i++)
            Assert.Equal(TakeResult.Used, filter.Take(Plain(i, i, i)));
        Assert.Equal(TakeResult.TooOld, filter.Take(Plain(20, 2.5, 2)));
        Assert.Equal(TakeResult.Used, filter.Take(Plain(21, 6.5, 6)));
    }

    [Fact]
    public void Take_OneSourceWithARegistrationError_NeverBecomesSurerThanThat()
    {
        var filter = new OutOfSequenceFilter(Window, 64);
        filter.Start(MotionModel.ConstantVelocity(1e-6, 0.1));
        for (int i = 0; i < 500; i++)
            filter.Take(Plain(i, 0.1 * i, 0) with { Registration = new HorizontalCovariance(4, 0, 4) });
        Assert.InRange(UpperTriangle(filter.Current)[0], 4, 4.2);

        // Against the same source the difference is small: both are off by the same.
        Assert.InRange(
            filter.Current.Expect(0, filter.Slots.Find(1), new HorizontalCovariance(4, 0, 4)).Covariance.NorthNorth,
            0,
            0.2);

        // A second source that is as wrong, and independently so, halves it.
        for (int i = 0; i < 500; i++)
        {
            TrackMeasurement other = Plain(i, 50 + (0.1 * i), 0);
            filter.Take(other with
            {
                Key = new ReportKey(2, i, 0),
                Registration = new HorizontalCovariance(4, 0, 4),
            });
        }

        Assert.InRange(UpperTriangle(filter.Current)[0], 2, 4);
    }

    [Fact]
    public void Take_SteadyFlow_AllocatesNothing()
    {
        var filter = new OutOfSequenceFilter(Window, 64);
        filter.Start(MotionModel.TwoModes(0.05, 3, 5, 0.1, 0.3));
        int next = 0;
        void Work()
        {
            for (int i = 0; i < 200; i++)
            {
                next++;
                filter.Take(Plain(next, 0.5 * (next % 3 == 0 ? next - 3 : next), next));
            }
        }

        Work();
        Assert.Equal(0, Allocated.By(Work));
    }

    private static TrackMeasurement Plain(int number, double seconds, double north) => new(
        new ReportKey(1, number, 0),
        TimeSpan.FromSeconds(seconds),
        north,
        0,
        new HorizontalCovariance(1, 0, 1),
        default);

    private static OutOfSequenceFilter Filtered(MotionModel model, TrackMeasurement[] measurements)
    {
        var filter = new OutOfSequenceFilter(Window, 64);
        filter.Start(model);
        foreach (TrackMeasurement measurement in measurements)
            Assert.Equal(TakeResult.Used, filter.Take(measurement));
        return filter;
    }

    private static double[] State(MotionFilter filter)
        => [filter.North, filter.NorthRate, filter.East, filter.EastRate];

    private static double[] UpperTriangle(MotionFilter filter)
    {
        double[] p = new double[16];
        filter.CopyCovarianceTo(p);
        return [p[0], p[1], p[2], p[3], p[5], p[6], p[7], p[10], p[11], p[15]];
    }

    private static double Difference(double[] expected, double[] actual)
    {
        Assert.Equal(expected.Length, actual.Length);
        return expected.Zip(actual, (e, a) => Math.Abs(e - a)).Max() / Math.Max(1, expected.Max(Math.Abs));
    }

    // "u2:13" is report 13 of vehicle 2.
    private static TrackMeasurement Measurement(JsonElement arrival)
    {
        string[] key = arrival.GetProperty("key").GetString()!.TrimStart('u').Split(':');
        var of = new ReportKey(
            byte.Parse(key[0], CultureInfo.InvariantCulture),
            long.Parse(key[1], CultureInfo.InvariantCulture),
            0);
        return Measurement(arrival, 0, Seconds(arrival, "t")) with { Key = of };
    }

    private static TrackMeasurement Measurement(JsonElement element, int number, TimeSpan time)
    {
        double[] z = Numbers(element, "z");
        double[] r = Numbers(element, "R");
        return new(
            new ReportKey(1, number, 0), time, z[0], z[1], new HorizontalCovariance(r[0], r[1], r[2]), default);
    }

    private static TimeSpan Seconds(JsonElement element, string name)
        => TimeSpan.FromTicks((long)Math.Round(element.GetProperty(name).GetDouble() * TimeSpan.TicksPerSecond));

    private static double[] Numbers(JsonElement element, string name)
        => element.GetProperty(name).EnumerateArray().Select(n => n.GetDouble()).ToArray();
}
