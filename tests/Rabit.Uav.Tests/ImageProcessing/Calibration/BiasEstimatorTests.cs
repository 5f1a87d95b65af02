using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Calibration;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.ImageProcessing.Calibration;

public sealed class BiasEstimatorTests(ITestOutputHelper output)
{
    private static readonly BiasParameter[] Mount =
        [BiasParameter.MountRoll, BiasParameter.MountPitch, BiasParameter.MountYaw];

    [Fact]
    public void Estimate_ReciprocalPassesAtTwoHeights_FindsTheMount()
    {
        const int Seeds = 50;
        var worst = new double[3];
        var rms = new double[3];
        double nees = 0;
        double pointNees = 0;
        for (int seed = 1; seed <= Seeds; seed++)
        {
            CalibrationFlight flight = Calibrated(seed);
            BiasEstimate estimate = flight.Estimator(CalibrationFlight.Options).Estimate()!;
            var error = new double[3];
            for (int i = 0; i < 3; i++)
            {
                Assert.True(
                    estimate.TryGet(Mount[i], out double value, out _), $"seed {seed}: {Mount[i]} is not observed");
                error[i] = value - flight.Mount[i];
                worst[i] = Math.Max(worst[i], Math.Abs(error[i]) / Vectors.Degree);
                rms[i] += error[i] * error[i] / (Vectors.Degree * Vectors.Degree) / Seeds;
            }

            nees += Squared(estimate, error) / Seeds;
            foreach (var point in estimate.Points)
            {
                (double north, double east) = CalibrationFlight.OffsetOf(point.Value.Position);
                (double trueNorth, double trueEast) = flight.Truth(point.Key);
                pointNees += point.Value.Covariance.MahalanobisSquared(trueNorth - north, trueEast - east) / Seeds
                    / estimate.Points.Count;
            }
        }

        output.WriteLine(FormattableString.Invariant(
            $"worst {worst[0]:0.000} {worst[1]:0.000} {worst[2]:0.000} deg, rms {Math.Sqrt(rms[0]):0.000} {Math.Sqrt(rms[1]):0.000} {Math.Sqrt(rms[2]):0.000} deg, NEES {nees:0.00} of 3, points {pointNees:0.00} of 2"));
        Assert.True(worst[0] <= 0.3 && worst[1] <= 0.3 && worst[2] <= 1, $"worst {worst[0]} {worst[1]} {worst[2]}");

        // Chi-square with 150 degrees of freedom, 2.5 and 97.5 %, by 50. The points of a flight share the vehicle's
        // bias: 50 of 2.
        Assert.InRange(nees, 2.36, 3.72);
        Assert.InRange(pointNees, 1.48, 2.59);
    }

    [Fact]
    public void Estimate_OneStraightPassOverOnePoint_SaysThatRollAndTimeAreNotSeen()
    {
        var flight = new CalibrationFlight(3);
        flight.Pass(30, 80, onlyMiddle: true);
        BiasEstimate estimate = flight.Estimator(CalibrationFlight.Options).Estimate()!;
        foreach (BiasCombination combination in estimate.Unobserved)
            output.WriteLine(combination.ToString());
        Assert.False(estimate.TryGet(BiasParameter.MountRoll, out double roll, out double sigma));
        Assert.True(double.IsNaN(roll) && sigma > 1 * Vectors.Degree);
        Assert.False(estimate.TryGet(BiasParameter.Time, out _, out _));
        Assert.Contains(estimate.Unobserved, c => Math.Abs(c.Weights[BiasParameter.MountRoll]) > 0.6);
        Assert.Contains(estimate.Unobserved, c => Math.Abs(c.Weights[BiasParameter.Time]) > 0.6);
    }

    [Fact]
    public void Estimate_OneSteadyOrbit_SaysWhichCombinationsAreNotSeen()
    {
        var flight = new CalibrationFlight(4);
        flight.Orbit(80, 80);
        BiasOptions options = CalibrationFlight.Options;
        options.Time = TimeSpan.FromMilliseconds(300);
        BiasEstimate estimate = flight.Estimator(options).Estimate()!;
        foreach (BiasCombination combination in estimate.Unobserved)
            output.WriteLine(combination.ToString());
        Assert.True(estimate.Fit.Observations > 60);

        // A lag turns the whole flight about the point, which is not visible, and yaw turns the picture about it;
        // towards the middle roll and height are mixed.
        foreach (BiasParameter parameter in new[] { BiasParameter.MountYaw, BiasParameter.Time, BiasParameter.Down })
            Assert.False(estimate.TryGet(parameter, out _, out _), parameter.ToString());
        Assert.Contains(
            estimate.Unobserved,
            c => Math.Abs(c.Weights[BiasParameter.Time]) > 0.3 && Math.Abs(c.Weights[BiasParameter.MountYaw]) > 0.3);
        Assert.Contains(
            estimate.Unobserved,
            c => Math.Abs(c.Weights[BiasParameter.Down]) > 0.3 && Math.Abs(c.Weights[BiasParameter.MountRoll]) > 0.2);
    }

    [Fact]
    public void Estimate_AnyFlight_NeverFindsTheVehiclesHorizontalBias()
    {
        BiasEstimate estimate = Calibrated(8).Estimator(CalibrationFlight.Options).Estimate()!;
        foreach (BiasParameter axis in new[] { BiasParameter.North, BiasParameter.East })
        {
            Assert.False(estimate.TryGet(axis, out _, out double sigma));
            Assert.Equal(1.5, sigma, 0.01);
            Assert.Contains(estimate.Unobserved, c => Math.Abs(c.Weights[axis]) > 0.6);
        }

        Assert.All(
            estimate.Points.Values,
            p => Assert.True(p.Covariance.NorthNorth > 1.5 * 1.5 && p.Covariance.EastEast > 1.5 * 1.5));
    }

    [Fact]
    public void Estimate_MountAndAttitudeBothUnknown_SaysThatOnlyTheirSumIsSeen()
    {
        BiasOptions options = CalibrationFlight.Options;
        (options.Attitude, options.Heading) = (Angle.FromDegrees(2), Angle.FromDegrees(2));
        BiasEstimate estimate = Calibrated(9).Estimator(options).Estimate()!;
        Assert.False(estimate.TryGet(BiasParameter.MountRoll, out _, out _));
        Assert.Contains(estimate.Unobserved, c =>
            Math.Abs(c.Weights[BiasParameter.MountRoll]) > 0.3
                && Math.Abs(c.Weights[BiasParameter.AttitudeRoll]) > 0.3);
    }

    [Fact]
    public void Add_ObservationThatShowsNoGround_IsRefusedAndCounted()
    {
        BiasEstimator estimator = new(
            CalibrationFlight.Camera, new CameraMount(), CalibrationFlight.Ground, CalibrationFlight.Options);
        Assert.Null(estimator.Estimate());
        Assert.False(estimator.Add(
            new BiasObservation { Column = 320, Row = 240, Position = GeodeticPosition.FromRadians(0.8, 0.1, 500) }));
        Assert.False(
            estimator.Add(
                new BiasObservation
                {
                    Column = double.NaN,
                    Row = 240,
                    Position = GeodeticPosition.FromRadians(0.8, 0.1, 500),
                    GimbalPitch = Angle.FromRadians(-1.5)
                }));
        Assert.True(
            estimator.Add(
                new BiasObservation
                {
                    Column = 320,
                    Row = 240,
                    Position = GeodeticPosition.FromRadians(0.8, 0.1, 500),
                    GimbalPitch = Angle.FromRadians(-1.5)
                }));
        Assert.Equal(2, estimator.Estimate()!.Fit.Refused);
    }

    [Fact]
    public void Constructor_BadOptions_NamesAll()
    {
        var options = new BiasOptions { PixelNoise = 0, Mount = Angle.FromRadians(-1) };
        string text = Assert.Throws<ArgumentException>(
            () => new BiasEstimator(CalibrationFlight.Camera, new CameraMount(), default, options)).Message;
        Assert.Contains("PixelNoise", text, StringComparison.Ordinal);
        Assert.Contains("Mount is", text, StringComparison.Ordinal);
    }

    private static CalibrationFlight Calibrated(int seed)
    {
        var flight = new CalibrationFlight(seed);
        foreach (double height in new[] { 60.0, 110.0 })
        {
            flight.Pass(20, height, 5);
            flight.Pass(200, height, -5);
            flight.Pass(110, height, 5);
            flight.Pass(290, height, -5);
        }

        return flight;
    }

    private static double Squared(BiasEstimate estimate, double[] error)
    {
        var covariance = new double[3, 3];
        for (int i = 0; i < 9; i++)
            covariance[i / 3, i % 3] = estimate.Covariance(Mount[i / 3], Mount[i % 3]);
        double[,] inverse = SymmetricMatrix.Invert(covariance)!;
        return Enumerable.Range(0, 9).Sum(i => error[i / 3] * inverse[i / 3, i % 3] * error[i % 3]);
    }
}
