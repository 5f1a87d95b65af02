using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Where painted cars, persons and squares point, by the shape detector.</summary>
public sealed class PatchBearingTests(ITestOutputHelper output)
{
    private static readonly (double, double, double) Red = (205, 28, 32);

    private static readonly ImmutableArray<TargetClass> Classes =
    [
        new("car")
        {
            Colour = new ColourRange(205, 28, 32), MinSideMetres = 2.2, MaxSideMetres = 3.5, MinAspect = 1.6,
            MaxAspect = 3.2, MinColourShare = 0.7,
        },
        new("panel") { Colour = new ColourRange(28, 72, 205), MaxAspect = 1.3 },
        new("person")
        {
            Colour = new ColourRange(242, 112, 18), MinSideMetres = 0.6, MaxSideMetres = 1.2, MinAspect = 2.2,
            MaxAspect = 4.5, MinColourShare = 0.7,
        },
    ];

    private readonly TargetDetection[] _found = new TargetDetection[16];

    [Theory]
    [InlineData("car", 4.5, 1.8, 0.06)]
    [InlineData("car", 4.5, 1.8, 0.2)]
    [InlineData("person", 1.7, 0.5, 0.05)]
    [InlineData("person", 1.7, 0.5, 0.08)]
    public void Detect_LongTargets_KnowsTheirDirectionAndHowWell(
        string name, double length, double width, double metresPerPixel)
    {
        const int seed = 90;
        var random = new Random(seed);
        var sigmas = new List<double>();
        (double worst, double stated) = (0, 0);
        for (int picture = 0; picture < 12; picture++)
        {
            double[] angles = [.. Enumerable.Range(0, 4).Select(_ => Math.PI * random.NextDouble())];
            var painting = new Painting(seed + picture);
            for (int i = 0; i < angles.Length; i++)
            {
                painting.Rectangle(
                    name == "car" ? Red : (242, 112, 18), 90 + (150 * i) + random.NextDouble(),
                    240 + random.NextDouble(), length / metresPerPixel, width / metresPerPixel, angles[i]);
            }

            int count = Detect(painting.Finish(), metresPerPixel);
            foreach (TargetDetection found in _found.Take(count))
            {
                // Columns go east and rows south: the first axis of the picture points to 90 degrees.
                double angle = (Math.PI / 2) + angles[(int)Math.Round((found.CentreX - 90) / 150)];
                TargetBearing bearing = found.Bearing!.Value;
                Assert.Equal((name, BearingSymmetry.HalfTurn), (found.Class.ToString(), bearing.Symmetry));
                double off = bearing.DistanceTo(Angle.FromRadians(angle)).Degrees;
                (worst, stated) = (Math.Max(worst, off), Math.Max(stated, bearing.Sigma.Degrees));
                sigmas.Add(off / bearing.Sigma.Degrees);
            }
        }

        double nees = sigmas.Average(s => s * s);
        output.WriteLine(FormattableString.Invariant(
            $"seed {seed}, {name} at {metresPerPixel}: {sigmas.Count}, off by {worst:0.00}° at most, states {stated:0.00}°, NEES {nees:0.00}"));
        Assert.True(sigmas.Count >= 44, $"seed {seed}: {sigmas.Count}");
        Assert.True(nees < 1.3 && sigmas.Max() < 3.5, $"seed {seed}: {nees}, {sigmas.Max()}");
    }

    [Theory]
    [InlineData(12)]
    [InlineData(14)]
    [InlineData(25)]
    public void Detect_Square_KnowsTheDirectionOfItsSides(double pixels)
    {
        const int seed = 60;
        var random = new Random(seed);
        var sigmas = new List<double>();
        for (int picture = 0; picture < 40; picture++)
        {
            double angle = Math.PI * random.NextDouble();
            var painting = new Painting(seed + picture);
            painting.Rectangle(
                (28, 72, 205), 200 + random.NextDouble(), 200 + random.NextDouble(), pixels, pixels, angle);
            Assert.Equal(1, Detect(painting.Finish(), 1 / pixels));
            TargetBearing bearing = _found[0].Bearing!.Value;
            Assert.Equal(BearingSymmetry.QuarterTurn, bearing.Symmetry);
            sigmas.Add(bearing.DistanceTo(Angle.FromRadians((Math.PI / 2) + angle)).Degrees / bearing.Sigma.Degrees);
        }

        double nees = sigmas.Average(s => s * s);
        output.WriteLine(
            FormattableString.Invariant($"seed {seed}, {pixels} px: NEES {nees:0.00}, {sigmas.Max():0.0}"));
        Assert.True(nees < 1.3 && sigmas.Max() < 3.5, $"seed {seed}: {nees}, {sigmas.Max()}");
    }

    [Theory]
    [InlineData(6, 6)]     // the raster has as much of a direction
    [InlineData(14, 28)]   // round: many narrow ones around one centre
    public void Detect_SmallOrRound_HasNoDirection(double pixels, int corners)
    {
        var painting = new Painting(5);
        for (int i = 0; i < corners; i++)
        {
            painting.Rectangle(
                (28, 72, 205), 200, 200, pixels, pixels * (corners > 6 ? 0.1 : 1), Math.PI * i / corners);
        }

        Assert.Equal(1, Detect(painting.Finish(), 1 / pixels));
        Assert.Null(_found[0].Bearing);
    }

    private int Detect(byte[] picture, double metresPerPixel)
    {
        var input = new DetectorInput(
            picture, Painting.Width, Painting.Height, Classes, PictureGroundScale.Uniform(metresPerPixel));
        int count = new ShapeTargetDetector(Classes).Detect(input, _found).Count;
        Assert.All(_found.Take(count), f => Assert.Null(DetectionCheck.FindFault(f, input)));
        return count;
    }
}
