using System;
using System.Linq;
using System.Text.Json;
using Rabit.Uav.SensorFusion.Moving;
using Xunit;

namespace Rabit.Uav.Tests.SensorFusion.Moving;

/// <summary>Against the minimum found elsewhere (tests/data/autonomy/kalman.json).</summary>
public class CovarianceIntersectionTests
{
    [Fact]
    public void TryFuse_ReferencePairs_FindsTheLeastDeterminant()
    {
        using JsonDocument data = TestData.Autonomy("kalman.json");
        int cases = 0;
        foreach (JsonElement pair in data.RootElement.GetProperty("covariance_intersection").EnumerateArray())
        {
            int n = pair.GetProperty("dim").GetInt32();
            double[] x = new double[n];
            double[] p = new double[n * n];
            Assert.True(CovarianceIntersection.TryFuse(
                Numbers(pair, "xa"),
                Full(Numbers(pair, "Pa"), n),
                Numbers(pair, "xb"),
                Full(Numbers(pair, "Pb"), n),
                x,
                p,
                out double weight));
            AssertNear(Full(Numbers(pair, "P"), n), p);
            if (pair.GetProperty("w_unique").GetBoolean())
            {
                AssertNear(Numbers(pair, "x"), x);
                Assert.Equal(pair.GetProperty("w").GetDouble(), weight, 1e-4);
            }
            else
            {
                Assert.Equal(0.5, weight);
            }

            cases++;
        }

        Assert.Equal(80, cases);
    }

    [Fact]
    public void TryFuse_TheSameEstimateTwice_IsNoSurer()
    {
        double[] p = [4, 1, 1, 3];
        double[] x = [10, 20];
        double[] fusedX = new double[2];
        double[] fusedP = new double[4];
        Assert.True(CovarianceIntersection.TryFuse(x, p, x, p, fusedX, fusedP, out _));
        AssertNear(p, fusedP);
        AssertNear(x, fusedX);
    }

    [Fact]
    public void TryFuse_NoCovariance_IsRefused()
    {
        double[] p = [4, 1, 1, 3];
        double[] x = [10, 20];
        double[] to = new double[4];
        Assert.False(CovarianceIntersection.TryFuse(x, p, x, [1, 2, 2, 1], x, to, out _));
        Assert.False(CovarianceIntersection.TryFuse(x, [double.NaN, 0, 0, 1], x, p, x, to, out _));
        Assert.False(CovarianceIntersection.TryFuse(x, p, x, [0, 0, 0, 1], x, to, out _));
        Assert.False(CovarianceIntersection.TryFuse(x, p, x, [double.PositiveInfinity, 0, 0, 1], x, to, out _));
        Assert.Equal(new double[4], to);
    }

    private static void AssertNear(double[] expected, double[] actual)
    {
        double size = Math.Max(1, expected.Max(Math.Abs));
        for (int i = 0; i < expected.Length; i++)
            Assert.Equal(expected[i], actual[i], 1e-6 * size);
    }

    private static double[] Full(double[] upperTriangle, int n)
    {
        double[] full = new double[n * n];
        int next = 0;
        for (int row = 0; row < n; row++)
        {
            for (int column = row; column < n; column++)
                full[(row * n) + column] = full[(column * n) + row] = upperTriangle[next++];
        }

        return full;
    }

    private static double[] Numbers(JsonElement element, string name)
        => element.GetProperty(name).EnumerateArray().Select(n => n.GetDouble()).ToArray();
}
