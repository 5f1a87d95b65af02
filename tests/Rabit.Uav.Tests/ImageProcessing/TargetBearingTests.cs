using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Bearings of targets: by their symmetry, from the pictures, and how wrong they may be.</summary>
public sealed class TargetBearingTests(ITestOutputHelper output)
{
    [Theory]
    [InlineData(BearingSymmetry.None, -10, 350)]
    [InlineData(BearingSymmetry.None, 725, 5)]
    [InlineData(BearingSymmetry.HalfTurn, -10, 170)]
    [InlineData(BearingSymmetry.HalfTurn, 180, 0)]
    [InlineData(BearingSymmetry.QuarterTurn, 100, 10)]
    public void Angle_AnyTurns_IsWithinThePeriod(BearingSymmetry symmetry, double degrees, double expected)
        => Assert.Equal(expected, Bearing(degrees, symmetry).Angle.Degrees, 1e-9);

    [Theory]
    [InlineData(BearingSymmetry.None, 10, 350, 20)]
    [InlineData(BearingSymmetry.None, 10, 190, 180)]
    [InlineData(BearingSymmetry.HalfTurn, 10, 350, 20)]
    [InlineData(BearingSymmetry.HalfTurn, 175, 2, 7)]
    [InlineData(BearingSymmetry.HalfTurn, 10, 190, 0)]
    [InlineData(BearingSymmetry.QuarterTurn, 88, 181, 3)]
    public void DistanceTo_Direction_IsTheLeastOfAllEnds(
        BearingSymmetry symmetry, double degrees, double direction, double expected)
        => Assert.Equal(
            expected, Bearing(degrees, symmetry).DistanceTo(Angle.FromDegrees(direction)).Degrees, 1e-9);

    [Theory]
    [InlineData(BearingSymmetry.None, "35° ±2.0°")]
    [InlineData(BearingSymmetry.HalfTurn, "35° ±2.0° or 180° more")]
    [InlineData(BearingSymmetry.QuarterTurn, "35° ±2.0° or 90°, 180°, 270° more")]
    public void ToString_SaysAllDirections(BearingSymmetry symmetry, string expected)
        => Assert.Equal(expected, Bearing(35, symmetry).ToString());

    [Fact]
    public void BearingOf_AnyViewWithErrors_IsTrueWithinItsErrors()
    {
        const int seed = 41;
        var random = new Random(seed);
        var budget = new ErrorBudget();
        (int views, double squares, double worst) = (0, 0, 0);
        while (views < 400)
        {
            var view = new TestView();
            view.SetAtRandom(random);
            double axis = Math.PI * random.NextDouble();
            if (!TryPlace(view, random, out double north, out double east)
                || !TrySee(view, north, east, axis, out TargetDetection seen))
                continue;
            GroundProjection exact = view.Projection(budget);
            Assert.True(exact.TryScale(seen.CentreX, seen.CentreY, out GroundScale scale));
            worst = Math.Max(
                worst,
                exact.BearingOf(seen.CentreX, seen.CentreY, PictureBearing(seen, scale), scale)!.Value
                    .DistanceTo(Angle.FromRadians(axis)).Degrees);
            TestView wrong = view.WithErrors(random, budget);
            wrong.CameraPitch = view.CameraPitch;
            wrong.CameraYaw = view.CameraYaw;
            GroundProjection projection = wrong.Projection(budget);
            if (!projection.TryScale(seen.CentreX, seen.CentreY, out scale)
                || projection.BearingOf(seen.CentreX, seen.CentreY, PictureBearing(seen, scale), scale)
                    is not { } bearing)
                continue;
            views++;
            double sigmas = bearing.DistanceTo(Angle.FromRadians(axis)) / bearing.Sigma;
            squares += sigmas * sigmas;
            Assert.True(bearing.SystematicSigma >= budget.HeadingBias, $"seed {seed}: {bearing}");
        }

        output.WriteLine(FormattableString.Invariant(
            $"seed {seed}: off by {worst:0.000}° at most without errors, NEES {squares / views:0.00} with them"));
        Assert.True(worst < 0.2, $"seed {seed}: {worst}");
        Assert.InRange(squares / views, 0.8, 1.25);
    }

    /// <summary>A vehicle that turns by 40 degrees a second, and a camera that reads its rows in 48 ms.</summary>
    [Theory]
    [InlineData(20)]
    [InlineData(459)]
    public void Report_RollingShutter_IsByThePoseOfItsRow(double row)
    {
        const double rate = 0.7;
        const double axis = 0.5;
        var camera = new CameraModel
        {
            Width = 640,
            Height = 480,
            FocalX = 530,
            FocalY = 530,
            CentreX = 320,
            CentreY = 240,
            Readout = TimeSpan.FromMilliseconds(48),
        };
        double later = camera.ReadoutOf(row).TotalSeconds;

        // Straight down the columns go to the right of the nose, and the rows to its back.
        double turned = axis - (rate * later);
        var detector = new OneDetection(input =>
        {
            Assert.True(input.GroundScale.TryAt(300, row, out GroundScale scale));
            double north = (scale.NorthByColumn * Math.Sin(turned)) - (scale.NorthByRow * Math.Cos(turned));
            double east = (scale.EastByColumn * Math.Sin(turned)) - (scale.EastByRow * Math.Cos(turned));
            return new TargetDetection
            {
                Class = DefaultTargetClasses.Red,
                CentreX = 300,
                CentreY = row,
                WidthPixels = 8,
                HeightPixels = 20,
                Score = 0.8,
                Covariance = PixelCovariance.FromSigma(0.5),
                Bearing = new TargetBearing(
                    Angle.FromRadians(Math.Atan2(east, north)), Angle.FromDegrees(1), BearingSymmetry.HalfTurn),
            };
        });
        using ImagingRig rig = ImagingRig.Search(
            ImagingRig.Grass, new ImageProcessingOptions { Camera = camera, Detector = detector });
        for (int i = 0; i <= 150; i++)
        {
            rig.AddPose(
                i / 50.0, rig.View.Position, default, EulerAngles.FromRadians(0, 0, rate * ((i / 50.0) - 1)),
                BodyRates.FromRadiansPerSecond(0, 0, rate));
        }

        rig.Camera!.Add(0, 1, deliveredAt: 1.15);
        rig.Run(2);
        TargetBearing bearing = Assert.Single(rig.Sink.Reports).Bearing!.Value;
        Assert.Equal(axis * 180 / Math.PI, bearing.Angle.Degrees, 0.1);
        Assert.Equal(BearingSymmetry.HalfTurn, bearing.Symmetry);
        Assert.InRange(bearing.Sigma.Degrees, Math.Sqrt(1 + 0.25), 1.4);
        Assert.InRange(bearing.SystematicSigma.Degrees, 1.02, 1.3);
    }

    [Fact]
    public void Report_DetectorMeasuresNone_HasNone()
    {
        using ImagingRig rig = ImagingRig.Search(
            ImagingRig.Panel, new ImageProcessingOptions { Detector = new WithoutBearings() });
        rig.AddPoses(0, 3);
        rig.Camera!.Add(0, 1, deliveredAt: 1.15);
        rig.Run(2);
        Assert.Null(Assert.Single(rig.Sink.Reports).Bearing);
    }

    private sealed class WithoutBearings : ITargetDetector
    {
        private readonly ShapeTargetDetector _detector = new(TargetClass.Defaults);

        public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
        {
            DetectorResult result = _detector.Detect(input, detections);
            foreach (ref TargetDetection one in detections.Slice(0, result.Count))
                one.Bearing = null;
            return result;
        }
    }

    private static TargetBearing Bearing(double degrees, BearingSymmetry symmetry)
        => new(Angle.FromDegrees(degrees), Angle.FromDegrees(2), symmetry);

    private static bool TryPlace(TestView view, Random random, out double north, out double east)
    {
        (double column, double row) = (100 + (440 * random.NextDouble()), 100 + (280 * random.NextDouble()));
        bool isGround = view.Projection(new ErrorBudget()).TryProjectToGround(column, row, out NedPosition ground);
        (north, east) = (ground.North, ground.East);
        return isGround && ground.HorizontalDistanceTo(NedPosition.Origin) < 4 * view.HeightMetres;
    }

    // The axis in the picture, radians from its columns to its rows, is kept as the bearing.
    private static bool TrySee(TestView view, double north, double east, double axis, out TargetDetection seen)
    {
        seen = default;
        (double n, double e) = (0.2 * Math.Cos(axis), 0.2 * Math.Sin(axis));
        if (!view.TryProject(north - n, east - e, out double fromX, out double fromY)
            || !view.TryProject(north + n, east + e, out double toX, out double toY)
            || !view.TryProject(north, east, out double x, out double y))
            return false;
        (seen.CentreX, seen.CentreY) = (x, y);
        seen.Bearing = new TargetBearing(
            Angle.FromRadians(Math.Atan2(toY - fromY, toX - fromX)), Angle.FromDegrees(0.001), BearingSymmetry.None);
        return true;
    }

    private static TargetBearing PictureBearing(in TargetDetection seen, in GroundScale scale)
    {
        double angle = seen.Bearing!.Value.Angle.Radians;
        (double x, double y) = (Math.Cos(angle), Math.Sin(angle));
        return new TargetBearing(
            Angle.FromRadians(Math.Atan2(
                (scale.EastByColumn * x) + (scale.EastByRow * y), (scale.NorthByColumn * x) + (scale.NorthByRow * y))),
            Angle.FromDegrees(0.001), BearingSymmetry.HalfTurn);
    }

    private sealed class OneDetection(Func<DetectorInput, TargetDetection> detect) : ITargetDetector
    {
        public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
        {
            detections[0] = detect(input);
            return DetectorResult.Found(1);
        }
    }
}
