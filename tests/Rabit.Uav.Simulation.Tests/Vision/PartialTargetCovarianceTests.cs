using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Vision;

/// <summary>
/// Whether the covariance of a panel's centre is true where a part of it is hidden, where the border of the picture
/// cuts it, and where it is overexposed, in drawn pictures: of each kind more than the generated sets have. As there,
/// the centre is that of what can be seen. The parameters were fitted to pictures with other seeds.
/// </summary>
public sealed class PartialTargetCovarianceTests(ITestOutputHelper output)
{
    // Of a chi-square distribution with two degrees of freedom.
    private const double Ellipse95 = 5.991;

    private const double MinFound = 0.96;

    private readonly ShapeTargetDetector _detector = new(PartialTargets.Classes);
    private readonly TargetDetection[] _found = new TargetDetection[64];

    /// <summary>As many as take a few seconds: the limits are as much wider as chance has it with so few.</summary>
    [Theory]
    [InlineData(PartialKind.Clear)]
    [InlineData(PartialKind.Hidden)]
    [InlineData(PartialKind.Cut)]
    [InlineData(PartialKind.Clipped)]
    public void Detect_SomeOfAKind_CovarianceIsTrue(PartialKind kind)
        => Check(kind, seed: 20_000, minTargets: 250, (1.2, 3.2), (0.89, 1));

    [Theory, Trait("Category", "Long")]
    [InlineData(PartialKind.Clear)]
    [InlineData(PartialKind.Hidden)]
    [InlineData(PartialKind.Cut)]
    [InlineData(PartialKind.Clipped)]
    public void Detect_ManyOfAKind_CovarianceIsTrue(PartialKind kind)
        => Check(kind, seed: 40_000, minTargets: 1000, (1.5, 2.8), (0.92, 0.98));

    private void Check(
        PartialKind kind, int seed, int minTargets, (double Min, double Max) means,
        (double Min, double Max) insides)
    {
        var squares = new List<double>();
        (int shown, double errors) = (0, 0);
        for (int next = seed; squares.Count < minTargets; next += 2)
        {
            var picture = new PartialTargets(next, kind);
            int count = _detector.Detect(
                new DetectorInput(
                    picture.Pixels, DrawnScene.Width, DrawnScene.Height, PartialTargets.Classes,
                    PictureGroundScale.Uniform(picture.MetresPerPixel)),
                _found).Count;
            foreach (PartialTarget target in picture.Targets)
            {
                shown++;
                foreach (TargetDetection found in _found.Take(count).Where(target.IsFoundBy).Take(1))
                {
                    (double x, double y) = (found.CentreX - target.SeenX, found.CentreY - target.SeenY);
                    squares.Add(NormalisedSquare(x, y, found.Covariance));
                    errors += (x * x) + (y * y);
                }
            }
        }

        double mean = squares.Average();
        double inside = squares.Count(s => s <= Ellipse95) / (double)squares.Count;
        string what = FormattableString.Invariant(
            $"seed {seed}, {kind}: {squares.Count} of {shown} found, RMS {Math.Sqrt(errors / squares.Count):0.000} px, mean NEES {mean:0.00}, {inside:0.000} inside");
        output.WriteLine(what);
        Assert.True(squares.Count >= MinFound * shown, what);
        Assert.True(mean >= means.Min && mean <= means.Max, what);
        Assert.True(inside >= insides.Min && inside <= insides.Max, what);
    }

    private static double NormalisedSquare(double x, double y, in PixelCovariance p)
        => ((p.RowRow * x * x) - (2 * p.ColumnRow * x * y) + (p.ColumnColumn * y * y))
            / ((p.ColumnColumn * p.RowRow) - (p.ColumnRow * p.ColumnRow));
}
