using System;
using System.Linq;
using Xunit;

namespace Rabit.Vision.Tests.Templates;

/// <summary>Histograms of oriented gradients of planes whose edges are known.</summary>
public sealed class HogFeaturesTests
{
    private const int Side = 48;

    [Theory]
    [InlineData(0, 0)]
    [InlineData(40, 2)]
    [InlineData(90, 4)]
    [InlineData(140, 7)]
    public void Compute_EdgesOfOneDirection_FillTheirBin(double degrees, int bin)
    {
        // Bins are 20 degrees wide, and begin at their number times 20.
        HogFeatures features = Of((x, y) => 0.5 + (0.3 * Math.Sin(((x * Cos(degrees)) + (y * Sin(degrees))) * 0.8)));
        float[] cell = new float[HogFeatures.Dimensions];
        features.CopyWindow(5, 6, 1, 1, cell);
        float[] directions = cell.Take(9).ToArray();
        int largest = Array.IndexOf(directions, directions.Max());
        Assert.True(largest == bin || largest == (bin + 1) % 9, string.Join(" ", directions));
    }

    [Fact]
    public void Compute_LessContrast_IsTheSame()
    {
        HogFeatures strong = Of((x, y) => 0.5 + (0.4 * Math.Sin((x * 0.7) + (y * y * 0.02))));
        float[] first = strong.Values.ToArray();
        float[] second = Of((x, y) => 0.3 + (0.1 * Math.Sin((x * 0.7) + (y * y * 0.02)))).Values.ToArray();
        Assert.All(Enumerable.Range(0, first.Length), i => Assert.Equal(first[i], second[i], 0.03));
    }

    [Fact]
    public void Compute_FlatPlane_IsZero()
        => Assert.All(Of((_, _) => 0.7).Values.ToArray(), value => Assert.Equal(0, value));

    [Fact]
    public void Dot_AndAddMultiple_AreThoseOfALoop()
    {
        var random = new Random(3);
        for (int length = 0; length < 40; length++)
        {
            float[] a = Enumerable.Range(0, length).Select(_ => (float)random.NextDouble()).ToArray();
            float[] b = Enumerable.Range(0, length).Select(_ => (float)random.NextDouble()).ToArray();
            Assert.Equal(a.Zip(b, (x, y) => (double)x * y).Sum(), FloatRows.Dot(a, b), 4);
            float[] expected = a.Zip(b, (x, y) => x + (y * 0.3f)).ToArray();
            FloatRows.AddMultiple(a, b, 0.3f);
            Assert.Equal(expected, a);
        }
    }

    private static HogFeatures Of(Func<int, int, double> value)
    {
        float[] plane = Enumerable.Range(0, Side * Side).Select(i => (float)value(i % Side, i / Side)).ToArray();
        var features = new HogFeatures();
        features.Compute(plane, Side, Side, 4);
        return features;
    }

    private static double Cos(double degrees) => Math.Cos(degrees * Math.PI / 180);

    private static double Sin(double degrees) => Math.Sin(degrees * Math.PI / 180);
}
