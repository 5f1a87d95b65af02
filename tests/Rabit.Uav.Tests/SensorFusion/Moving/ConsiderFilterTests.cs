using System;
using System.Linq;
using System.Text.Json;
using Rabit.Tests.Shared;
using Rabit.Geodesy;
using Rabit.Uav.SensorFusion;
using Rabit.Uav.SensorFusion.Moving;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.SensorFusion.Moving;

/// <summary>
/// Without registration errors: against Stone Soup (tests/data/autonomy/tracking.json), and against itself where that
/// has nothing to say.
/// </summary>
public class ConsiderFilterTests(ITestOutputHelper output)
{
    [Fact]
    public void Filter_ReferenceSequences_AgreesToOnePartInABillion()
    {
        using JsonDocument data = TestData.Autonomy("tracking.json");
        int steps = 0;
        foreach (JsonElement sequence in data.RootElement.GetProperty("kf_sequences").EnumerateArray())
        {
            var filter = new ConsiderFilter();
            filter.Start(Numbers(sequence, "x0"), Numbers(sequence, "P0"));
            double q = sequence.GetProperty("q").GetDouble();
            foreach (JsonElement step in sequence.GetProperty("steps").EnumerateArray())
            {
                filter.Predict(step.GetProperty("dt").GetDouble(), q);
                AssertState(step, "x_pred", "P_pred", filter);
                steps++;
                if (!step.TryGetProperty("z", out _))
                    continue;
                double[] z = Numbers(step, "z");
                double[] r = Numbers(step, "R");
                var covariance = new HorizontalCovariance(r[0], r[1], r[2]);
                Innovation innovation = Update(filter, z[0], z[1], covariance);
                AssertNear(Numbers(step, "nu"), [innovation.North, innovation.East]);
                AssertNear(Numbers(step, "S"), [
                    innovation.Covariance.NorthNorth, innovation.Covariance.NorthEast, innovation.Covariance.EastEast
                ]);
                AssertNear([step.GetProperty("d2").GetDouble()], [innovation.DistanceSquared]);
                AssertNear([step.GetProperty("cost_d2_plus_lndetS").GetDouble()], [innovation.Cost]);
                AssertState(step, "x", "P", filter);
            }
        }

        Assert.InRange(steps, 50, 1000);
    }

    [Fact]
    public void Gate_DefaultAndMerge_AreThoseOfChiSquare()
    {
        using JsonDocument data = TestData.Autonomy("tracking.json");
        double Gate(double p) => data.RootElement.GetProperty("chi2_gates").EnumerateArray()
            .Single(g => g.GetProperty("p").GetDouble().Equals(p)).GetProperty("gate").GetDouble();
        Assert.Equal(Gate(0.99), new SensorFusionOptions().Gate, 0.001);
        Assert.False(new HorizontalCovariance(1, 0, 1).Contains95(Math.Sqrt(Gate(0.95)) + 1e-9, 0));
        Assert.True(new HorizontalCovariance(1, 0, 1).Contains95(Math.Sqrt(Gate(0.95)) - 1e-9, 0));
    }

    [Fact]
    public void Filter_SeededTargets_IsAsSureAsItShouldBe()
    {
        const int Runs = 200;
        const int Seed = 7;
        output.WriteLine($"seed {Seed}");
        var random = new SeededNumbers(Seed);
        double sum = 0;
        for (int run = 0; run < Runs; run++)
        {
            (double n, double e, double vn, double ve) =
                (random.Gauss(), random.Gauss(), random.Gauss(), random.Gauss());
            double sn = random.Uniform(0.5, 3);
            double se = random.Uniform(0.5, 3);
            var r = new HorizontalCovariance(sn * sn, 0, se * se);
            var filter = new ConsiderFilter();
            filter.Start(Measured(n + (sn * random.Gauss()), e + (se * random.Gauss()), r), slot: -1, velocitySigma: 1);
            for (int step = 0; step < 20; step++)
            {
                (n, e) = (n + (0.5 * vn), e + (0.5 * ve));
                filter.Predict(0.5, 0);
                Update(filter, n + (sn * random.Gauss()), e + (se * random.Gauss()), r);
            }

            sum += filter.PositionCovariance.MahalanobisSquared(n - filter.State[0], e - filter.State[2]);
        }

        using JsonDocument data = TestData.Autonomy("tracking.json");
        JsonElement band = data.RootElement.GetProperty("nees_95_bands").EnumerateArray()
            .Single(b => b.GetProperty("dof").GetInt32() == 2 && b.GetProperty("runs").GetInt32() == Runs);
        output.WriteLine($"mean NEES {sum / Runs:0.00}");
        Assert.InRange(sum / Runs, band.GetProperty("lower").GetDouble(), band.GetProperty("upper").GetDouble());
    }

    [Fact]
    public void Filter_PredictAndUpdate_AllocatesNothing()
    {
        var filter = new ConsiderFilter();
        filter.Start(Measured(0, 0, new HorizontalCovariance(1, 0, 1)), slot: -1, velocitySigma: 1);
        void Work()
        {
            for (int i = 0; i < 1000; i++)
            {
                filter.Predict(0.1, 0.1);
                Update(filter, 1, 1, new HorizontalCovariance(1, 0.1, 1));
            }
        }

        Work();
        Assert.Equal(0, Allocated.By(Work));
    }

    private static TrackMeasurement Measured(double north, double east, HorizontalCovariance covariance)
        => new(default, TimeSpan.Zero, north, east, covariance, default);

    private static Innovation Update(
        ConsiderFilter filter, double north, double east, HorizontalCovariance covariance)
            => filter.Update(Measured(north, east, covariance), slot: -1, slots: 0);

    private static void AssertState(JsonElement step, string x, string p, ConsiderFilter filter)
    {
        AssertNear(Numbers(step, x), filter.State);
        double[] all = filter.Covariance;
        double[] upper = [.. Enumerable.Range(0, 4).SelectMany(row => all.Skip((4 * row) + row).Take(4 - row))];
        AssertNear(Numbers(step, p), upper);
    }

    private static void AssertNear(double[] expected, double[] actual)
    {
        Assert.Equal(expected.Length, actual.Length);
        double size = expected.Max(Math.Abs);
        for (int i = 0; i < expected.Length; i++)
            Assert.InRange(
                actual[i], expected[i] - (1e-9 * Math.Max(1, size)), expected[i] + (1e-9 * Math.Max(1, size)));
    }

    private static double[] Numbers(JsonElement element, string name)
        => element.GetProperty(name).EnumerateArray().Select(n => n.GetDouble()).ToArray();
}
