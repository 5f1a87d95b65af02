using System;
using System.Linq;
using System.Text.Json;
using Rabit.Tests.Shared;
using Rabit.Geodesy;
using Rabit.Uav.SensorFusion;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.SensorFusion;

/// <summary>
/// Against Stone Soup (tests/data/autonomy/tracking.json), and against itself where that has nothing to say.
/// </summary>
public class PlanarFilterTests(ITestOutputHelper output)
{
    [Fact]
    public void Filter_ReferenceSequences_AgreesToOnePartInABillion()
    {
        using JsonDocument data = TestData.Autonomy("tracking.json");
        int steps = 0;
        foreach (JsonElement sequence in data.RootElement.GetProperty("kf_sequences").EnumerateArray())
        {
            PlanarFilter filter = PlanarFilter.From(Numbers(sequence, "x0"), Numbers(sequence, "P0"));
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
                Innovation innovation = filter.Expect(z[0], z[1], covariance, 0);
                AssertNear(Numbers(step, "nu"), [innovation.North, innovation.East]);
                AssertNear(Numbers(step, "S"), [
                    innovation.Covariance.NorthNorth, innovation.Covariance.NorthEast, innovation.Covariance.EastEast
                ]);
                AssertNear([step.GetProperty("d2").GetDouble()], [innovation.DistanceSquared]);
                AssertNear([step.GetProperty("cost_d2_plus_lndetS").GetDouble()], [innovation.Cost]);
                filter.Update(z[0], z[1], covariance, 0);
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
    public void Update_LateMeasurementWithoutProcessNoise_IsAsInOrder()
    {
        var early = new HorizontalCovariance(4, 1, 3);
        var late = new HorizontalCovariance(2, -0.5, 5);
        PlanarFilter start = PlanarFilter.From(10, 20, new HorizontalCovariance(9, 0, 9), 3);
        PlanarFilter inOrder = start;
        inOrder.Predict(1, 0);
        inOrder.Update(12, 21, early, 0);
        inOrder.Predict(2, 0);
        inOrder.Update(15, 24, late, 0);

        PlanarFilter outOfOrder = start;
        outOfOrder.Predict(3, 0);
        outOfOrder.Update(15, 24, late, 0);
        outOfOrder.Update(12, 21, early, 2);
        AssertNear(State(inOrder), State(outOfOrder));
        AssertNear(Covariance(inOrder), Covariance(outOfOrder));
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
            PlanarFilter filter = PlanarFilter.From(n + (sn * random.Gauss()), e + (se * random.Gauss()), r, 1);
            for (int step = 0; step < 20; step++)
            {
                (n, e) = (n + (0.5 * vn), e + (0.5 * ve));
                filter.Predict(0.5, 0);
                filter.Update(n + (sn * random.Gauss()), e + (se * random.Gauss()), r, 0);
            }

            sum += filter.PositionCovariance.MahalanobisSquared(n - filter.North, e - filter.East);
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
        PlanarFilter filter = PlanarFilter.From(0, 0, new HorizontalCovariance(1, 0, 1), 1);
        void Work()
        {
            for (int i = 0; i < 1000; i++)
            {
                filter.Predict(0.1, 0.1);
                filter.Update(1, 1, new HorizontalCovariance(1, 0.1, 1), 0.01);
            }
        }

        Work();
        Assert.Equal(0, Allocated.By(Work));
    }

    private static void AssertState(JsonElement step, string x, string p, PlanarFilter filter)
    {
        AssertNear(Numbers(step, x), State(filter));
        AssertNear(Numbers(step, p), Covariance(filter));
    }

    private static double[] State(PlanarFilter filter)
        => [filter.North, filter.NorthRate, filter.East, filter.EastRate];

    private static double[] Covariance(PlanarFilter filter)
    {
        double[] upper = new double[10];
        filter.CopyCovarianceTo(upper);
        return upper;
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
