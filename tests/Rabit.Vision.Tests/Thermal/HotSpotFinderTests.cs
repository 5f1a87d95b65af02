using System;
using System.Linq;
using System.Runtime.InteropServices;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Vision.Tests.Thermal;

/// <summary>Hot spots in painted thermal pictures: persons of 1.7 x 0.5 m, 14 x 4 pixels.</summary>
public sealed class HotSpotFinderTests(ITestOutputHelper output)
{
    // The longest person, and larger.
    private static readonly HotSpotLimits Limits = new() { MinSigmas = 6, MaxSide = 26 };

    private readonly HotSpotFinder _finder = new();

    [Fact]
    public void Find_PersonsAnyhow_FindsThemWithATrueCovariance()
    {
        const int seed = 300;
        var random = new Random(seed);
        (int found, int of, double squares, int inside) = (0, 0, 0, 0);
        for (int picture = 0; picture < 25; picture++)
        {
            var scene = new ThermalScene(seed + picture);
            (double X, double Y)[] places = [.. Enumerable.Range(0, 4).Select(i =>
                (40 + (70 * i) + (20 * random.NextDouble()), 40 + (170 * random.NextDouble())))];
            foreach ((double x, double y) in places)
                scene.Add(x, y, 1.7, 0.5, Math.PI * random.NextDouble(), 100 + (300 * random.NextDouble()));
            HotSpot[] spots = Find(scene.Finish());
            Assert.InRange(spots.Count(s => s.Area is > 20 and < 100), 4, 5);
            foreach ((double x, double y) in places)
            {
                of++;
                HotSpot[] near = [.. spots.Where(s => Math.Abs(s.CentreX - x) < 2 && Math.Abs(s.CentreY - y) < 2)];
                if (near.Length == 0)
                    continue;
                found++;
                double square = ErrorSquared(near[0], x, y);
                squares += square;
                inside += square <= 5.991 ? 1 : 0;
                Assert.InRange(near[0].Area, 35, 75);
            }
        }

        output.WriteLine(FormattableString.Invariant(
            $"seed {seed}: {found} of {of} found, NEES {squares / found:0.00}, {100.0 * inside / found:0} % inside"));
        Assert.Equal(of, found);
        Assert.InRange(squares / found, 0.8, 2.8);
        Assert.InRange((double)inside / found, 0.92, 1);
    }

    [Fact]
    public void Find_WarmRoofPipeAndDefects_FindsNoneOfThem()
    {
        var scene = new ThermalScene(2);
        scene.Add(80, 60, 6, 5, 0.3, 300);        // a roof
        scene.Add(200, 200, 25, 0.6, 0.1, 200);   // a pipe
        scene.Add(30, 200, 1.7, 0.5, 0, 20);      // hardly warmer than the ground
        for (int i = 0; i < 20; i++)
            scene.AddDefect(20 + (14 * i), 120 + (i % 5), 400 + (100 * i));
        HotSpot[] spots = Find(scene.Finish());
        Assert.Equal(20, _finder.DefectPixels);
        Assert.DoesNotContain(spots, s => s.Area < 200);
        Assert.InRange(_finder.Noise, 7, 9);
    }

    [Theory]
    [InlineData(1, 0)]
    [InlineData(1, 2500)]     // after the camera's calibration
    [InlineData(0.25, 100)]   // low gain
    [InlineData(2, -3000)]    // high gain
    public void Find_StepOfGainOrOffset_FindsTheSame(double gain, double offset)
    {
        var scene = new ThermalScene(3);
        scene.Add(100, 90, 1.7, 0.5, 0.4, 250);
        scene.Add(220, 150, 1.7, 0.5, 1.4, 150);
        HotSpot[] spots = [.. Find(scene.Finish(gain, offset)).Where(s => s.Area < 100).OrderBy(s => s.CentreX)];
        Assert.Equal(2, spots.Length);
        Assert.Equal(100, spots[0].CentreX, 0.3);
        Assert.Equal(220, spots[1].CentreX, 0.3);
        Assert.Equal(250 * gain, spots[0].Contrast, 30 * gain);
    }

    [Fact]
    public void Find_TwoBesideEachOther_FindsBoth()
    {
        var scene = new ThermalScene(5);
        scene.Add(100, 90, 1.7, 0.5, 0, 250);
        scene.Add(100, 100, 1.7, 0.5, 0, 150);
        Assert.Equal(2, Find(scene.Finish()).Count(s => s.Area < 100));
    }

    [Fact]
    public void Find_Saturated_SaysSo()
    {
        var scene = new ThermalScene(4);
        scene.Add(100, 90, 1.7, 0.5, 0.4, 900);
        Assert.Equal(0, Find(scene.Finish())[0].SaturatedPixels);
        HotSpot spot = Find(scene.Finish(gain: 2.1))[0];
        Assert.InRange(spot.SaturatedPixels, 20, 90);
        Assert.Equal(100, spot.CentreX, 0.3);
    }

    [Fact]
    public void Find_FurtherPictures_FindsTheSameAndAllocatesNothing()
    {
        var scene = new ThermalScene(7);
        scene.Add(100, 90, 1.7, 0.5, 0.4, 250);
        byte[] picture = scene.Finish();
        Assert.Equal(Find(picture), Find(picture));
        Assert.Equal(0, Allocated.By(() => _finder.Find(
            MemoryMarshal.Cast<byte, ushort>(picture), ThermalScene.Width, ThermalScene.Height, Limits)));
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(65535, 0)]
    [InlineData(0, 65535)]
    public void Find_FlatOrOfNoiseAlone_FindsNone(int level, int noise)
    {
        var random = new Random(1);
        ushort[] counts = [.. Enumerable.Range(0, 64 * 48).Select(_ => (ushort)(level + random.Next(noise + 1)))];
        Assert.Equal(0, _finder.Find(counts, 64, 48, Limits).Length);
        Assert.Equal(0, _finder.Find(counts.AsSpan(0, 1), 1, 1, Limits).Length);
        Assert.Throws<ArgumentException>(() => { _finder.Find(counts, 64, 49, Limits); });
    }

    private HotSpot[] Find(byte[] picture)
        => _finder.Find(
            MemoryMarshal.Cast<byte, ushort>(picture), ThermalScene.Width, ThermalScene.Height, Limits).ToArray();

    // With what the blur of the lens and the pixels add to the noise.
    private static double ErrorSquared(in HotSpot spot, double x, double y)
    {
        (double dx, double dy) = (spot.CentreX - x, spot.CentreY - y);
        (double xx, double xy, double yy) = (spot.VarianceX + 0.005, spot.CovarianceXY, spot.VarianceY + 0.005);
        return ((yy * dx * dx) - (2 * xy * dx * dy) + (xx * dy * dy)) / ((xx * yy) - (xy * xy));
    }
}
