using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Panels of 1 m on pale slabs of concrete, which are like a white thing on the grass around them.</summary>
public class PanelsOnSlabTests
{
    private const int Seed = 300;
    private const double MetresPerPixel = 0.08;
    private const double Side = 1 / MetresPerPixel;

    // In the yellowish light of the painted grass.
    private const double BlueOfNeutral = 0.93;

    private static readonly (double, double, double) White = (240, 240, 240 * BlueOfNeutral);
    private static readonly (double, double, double) Black = (22, 23, 25);
    private static readonly (double, double, double) Red = (205, 28, 32);

    private static readonly ImmutableArray<TargetClass> Classes =
    [
        ClassOf("white", 236, 236, 234),
        ClassOf("black", 22, 23, 25),
        ClassOf("red", 205, 28, 32),
    ];

    private readonly ShapeTargetDetector _detector = new(Classes);
    private readonly TargetDetection[] _found = new TargetDetection[16];

    [Theory]
    [InlineData(150, 6)]
    [InlineData(165, 6)]
    [InlineData(180, 6)]
    [InlineData(150, 2.6)]   // hardly larger than the largest target
    [InlineData(165, 2.6)]
    [InlineData(180, 2.6)]
    public void Detect_PanelsOnPaleSlabs_FindsThemAndNotTheSlabs(double level, double slabMetres)
    {
        for (int turn = 0; turn < 4; turn++)
        {
            string[] found = Search(Paint(Seed + turn, level, slabMetres / MetresPerPixel, 0.3 + turn));
            Assert.Equal(
                ["black at 320, 330", "red at 500, 140", "white at 120, 120", "white at 560, 400"], found);
        }
    }

    private static byte[] Paint(int seed, double level, double slab, double angle)
    {
        var painting = new Painting(seed);
        (double, double, double) concrete = (level, level, level * BlueOfNeutral);
        foreach ((double x, double y) in new[] { (120.0, 120.0), (320, 330), (500, 140) })
            painting.Rectangle(concrete, x, y, slab, 0.8 * slab, angle);
        painting.Rectangle(White, 120, 120, Side, Side, angle + 0.2);
        painting.Rectangle(Black, 320, 330, Side, Side, angle + 0.7);
        painting.Rectangle(Red, 500, 140, Side, Side, angle - 0.1);
        painting.Rectangle(White, 560, 400, Side, Side, angle);
        return painting.Finish();
    }

    private static TargetClass ClassOf(string name, byte red, byte green, byte blue)
        => new(name) { Colour = new ColourRange(red, green, blue), MaxSideMetres = 2.1 };

    private string[] Search(byte[] pixels)
    {
        var input = new DetectorInput(
            pixels, Painting.Width, Painting.Height, Classes, PictureGroundScale.Uniform(MetresPerPixel));
        DetectorResult result = _detector.Detect(input, _found);
        return [.. _found.Take(result.Count)
            .Select(f => FormattableString.Invariant($"{f.Class} at {f.CentreX:0}, {f.CentreY:0}"))
            .OrderBy(text => text, StringComparer.Ordinal)];
    }
}
