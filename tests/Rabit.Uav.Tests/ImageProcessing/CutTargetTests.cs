using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Targets that the border of the picture cuts, where the application asks for them.</summary>
public sealed class CutTargetTests(ITestOutputHelper output)
{
    private const double MetresPerPixel = 0.075;

    // Of a chi-square distribution with two degrees of freedom.
    private const double Ellipse95 = 5.991;

    private readonly ShapeTargetDetector _detector = new(TargetClass.Defaults);

    /// <summary>Squares of all sizes that the class may have, at each border and in each direction.</summary>
    [Fact]
    public void Whole_SquaresOfAllSizesCutByHalfAndLess_CoversWhereTheyAre()
    {
        const int seed = 5200;
        var random = new Random(seed);
        var squares = new List<double>();
        var found = new TargetDetection[16];
        (int shown, int grown) = (0, 0);
        for (int picture = 0; picture < 60; picture++)
        {
            var painting = new Painting(seed + picture);
            var truth = new List<(double X, double Y)>();
            for (int i = 0; i < 5; i++)
            {
                double side = (0.7 + (0.7 * random.NextDouble())) / MetresPerPixel;
                double inside = side * (0.05 + (0.4 * random.NextDouble()));
                double along = 70 + (80 * i) + (20 * random.NextDouble());
                (double x, double y) = (picture % 4) switch
                {
                    0 => (inside, along),
                    1 => (Painting.Width - 1 - inside, along),
                    2 => (along, inside),
                    _ => (along, Painting.Height - 1 - inside),
                };
                painting.Panel(TargetClass.Defaults[i].Name, x, y, side, Math.PI * random.NextDouble());
                truth.Add((x, y));
            }

            var input = new DetectorInput(
                painting.Finish(), Painting.Width, Painting.Height, TargetClass.Defaults,
                PictureGroundScale.Uniform(MetresPerPixel));
            int count = _detector.Detect(input, found).Count;
            shown += truth.Count;
            foreach (TargetDetection seen in found.Take(count).Where(f => f.IsCut))
            {
                TargetDetection whole = CutTarget.Whole(seen, input);
                Assert.Null(DetectionCheck.FindFault(whole, input));

                // The box grows beyond the border alone: its other side stays where it was seen.
                if (whole.CentreX is > 0 and < Painting.Width - 1)
                {
                    Assert.Equal(
                        2 * Math.Abs(whole.CentreX - seen.CentreX), whole.WidthPixels - seen.WidthPixels, 1e-6);
                    grown++;
                }

                (double x, double y) = truth.OrderBy(t => Square(t.X - seen.CentreX) + Square(t.Y - seen.CentreY))
                    .Select(t => (whole.CentreX - t.X, whole.CentreY - t.Y)).First();
                PixelCovariance p = whole.Covariance;
                squares.Add(((p.RowRow * x * x) - (2 * p.ColumnRow * x * y) + (p.ColumnColumn * y * y))
                    / ((p.ColumnColumn * p.RowRow) - Square(p.ColumnRow)));
            }
        }

        double inEllipse = squares.Count(s => s <= Ellipse95) / (double)squares.Count;
        string what = FormattableString.Invariant(
            $"seed {seed}: {squares.Count} of {shown}, mean NEES {squares.Average():0.00}, {inEllipse:0.000} inside");
        output.WriteLine(what);
        Assert.True(squares.Count >= 0.8 * shown && grown >= 0.5 * shown, what);
        Assert.True(squares.Average() is >= 0.3 and <= 2.8 && inEllipse >= 0.92, what);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Search_PanelCutByTheBorder_IsReportedWhereTheApplicationAsksForIt(bool isAskedFor)
    {
        var view = new TestView();
        Assert.True(view.Projection(new()).TryProjectToGround(3, 240, out NedPosition place));
        Assert.True(view.TryProject(place.North, place.East + 1, out double oneMetreOn, out _));
        var painting = new Painting(22);
        painting.Panel(DefaultTargetClasses.Red, 3, 240, oneMetreOn - 3, 0);
        var options = new ImageProcessingOptions { ReportsCutTargets = isAskedFor };
        using ImagingRig rig = ImagingRig.Search(painting.Finish(), options);
        rig.AddPoses(0, 2);
        rig.Camera!.Add(1, 1.5, 1.6);
        rig.Run(2);

        Assert.Equal(isAskedFor ? 0 : 1, rig.Status.DetectionsCut);
        Assert.Equal(isAskedFor ? 1 : 0, rig.Status.Reports);
        foreach (TargetReport report in rig.Sink.Reports)
        {
            Assert.Equal(DefaultTargetClasses.Red, report.Class);
            NedPosition found = LocalNedFrame.IgnoringGeoid(rig.View.Position).ToNed(report.Position);
            Assert.Equal(place.North, found.North, 0.1);
            Assert.Equal(place.East, found.East, 0.5);

            // East of straight down with the nose north: what the left border hides is uncertain, 2.6 pixels of 7.5 cm.
            Assert.InRange(report.Covariance.EastEast - report.Covariance.NorthNorth, 0.01, 0.1);
        }
    }

    private static double Square(double value) => value * value;
}
