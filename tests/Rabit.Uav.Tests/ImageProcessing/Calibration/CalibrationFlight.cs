using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Tests.Shared;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Calibration;

namespace Rabit.Uav.Tests.ImageProcessing.Calibration;

/// <summary>
/// A flight over standing points with all its errors, by geometry of its own: matrices, no product code but the lens.
/// </summary>
internal sealed class CalibrationFlight
{
    public const double SpeedMetresPerSecond = 12;

    private static readonly GeodeticPosition Home = GeodeticPosition.FromDegrees(47, 8, 400);
    private static readonly LocalNedFrame World = LocalNedFrame.IgnoringGeoid(Home);

    private readonly SeededNumbers _numbers;
    private readonly List<BiasObservation> _observations = [];
    private readonly (double North, double East)[] _points = [(0, 0), (25, -18), (-22, 20), (12, 28), (-15, -25)];
    private double _time;

    public CalibrationFlight(int seed)
    {
        _numbers = new SeededNumbers(seed);
        for (int i = 0; i < 7; i++)
            _numbers.Uniform();
        for (int i = 0; i < 3; i++)
            Mount[i] = 2 * Vectors.Degree * _numbers.Gauss();
        TimeSeconds = 0.02 * _numbers.Gauss();
        for (int i = 0; i < 3; i++)
            Gps[i] = 1.5 * _numbers.Gauss();
    }

    public static AmslAltitude Ground => new(400);

    public static CameraModel Camera
        => new()
        {
            Width = 640,
            Height = 480,
            FocalX = 530,
            FocalY = 530,
            CentreX = 319.5,
            CentreY = 239.5,
            K1 = -0.05
        };

    public static BiasOptions Options => new()
    {
        Mount = Angle.FromDegrees(2),
        Attitude = Angle.Zero,
        Heading = Angle.Zero,
        PositionMetres = 1.5,
        HeightMetres = 1.5,
        NoiseTime = TimeSpan.Zero,
    };

    public double[] Mount { get; } = new double[3];

    public double[] Gps { get; } = new double[3];

    public double TimeSeconds { get; }

    public (double North, double East) Truth(int point) => _points[point];

    public static (double North, double East) OffsetOf(GeodeticPosition position)
    {
        NedPosition ned = World.ToNed(position);
        return (ned.North, ned.East);
    }

    /// <summary>A straight pass over the points.</summary>
    public void Pass(double headingDegrees, double height, double offset = 0, bool onlyMiddle = false)
    {
        double heading = headingDegrees * Vectors.Degree;
        for (double along = -70; along <= 70; along += SpeedMetresPerSecond * 0.5)
        {
            _time += 0.5;
            Observe(
                new NedPosition(
                    (Math.Cos(heading) * along) - (Math.Sin(heading) * offset),
                    (Math.Sin(heading) * along) + (Math.Cos(heading) * offset), -height),
                new NedVector(SpeedMetresPerSecond * Math.Cos(heading), SpeedMetresPerSecond * Math.Sin(heading), 0),
                EulerAngles.FromRadians(0.02 * _numbers.Gauss(), 0.03 + (0.02 * _numbers.Gauss()), heading),
                default,
                onlyMiddle);
        }
    }

    /// <summary>One steady turn around the middle, leaning so that the camera's axis points there.</summary>
    public void Orbit(double radius, double height)
    {
        double rate = SpeedMetresPerSecond / radius;
        for (double angle = 0; angle < 2 * Math.PI; angle += rate * 0.5)
        {
            _time += 0.5;
            double bank = Math.Atan2(radius, height);
            Observe(
                new NedPosition(radius * Math.Cos(angle), radius * Math.Sin(angle), -height),
                new NedVector(-SpeedMetresPerSecond * Math.Sin(angle), SpeedMetresPerSecond * Math.Cos(angle), 0),
                EulerAngles.FromRadians(-bank, 0, angle + (Math.PI / 2)),
                BodyRates.FromRadiansPerSecond(0, -rate * Math.Sin(bank), rate * Math.Cos(bank)),
                onlyMiddle: true);
        }
    }

    public BiasEstimator Estimator(BiasOptions options)
    {
        var estimator = new BiasEstimator(Camera, new CameraMount(), Ground, options);
        foreach (BiasObservation observation in _observations)
            estimator.Add(observation);
        return estimator;
    }

    private void Observe(
        NedPosition position, NedVector velocity, EulerAngles attitude, BodyRates rates, bool onlyMiddle)
    {
        double[,] cameraToNed = Product(
            Euler(attitude.Roll.Radians, attitude.Pitch.Radians, attitude.Yaw.Radians),
            Product(Euler(Mount[0], Mount[1], Mount[2]), Down()));
        double noise = 0.3 * Vectors.Degree;
        for (int point = 0; point < (onlyMiddle ? 1 : _points.Length); point++)
        {
            double[] d = [_points[point].North - position.North, _points[point].East - position.East, -position.Down];
            double[] seen = [Dot(cameraToNed, d, 0), Dot(cameraToNed, d, 1), Dot(cameraToNed, d, 2)];
            if (!Camera.TryProject(seen[0], seen[1], seen[2], out double column, out double row)
                || column < 0 || row < 0 || column > 639 || row > 479)
                continue;

            // The stamp is late by the time bias: the autopilot reports where it was at that time.
            var reported = new NedPosition(
                position.North + (velocity.North * TimeSeconds) + Gps[0] + (0.3 * _numbers.Gauss()),
                position.East + (velocity.East * TimeSeconds) + Gps[1] + (0.3 * _numbers.Gauss()),
                position.Down + Gps[2] + (0.3 * _numbers.Gauss()));
            EulerAngles turned = Rotation.FromEuler(attitude).After(rates, TimeSeconds).ToEuler();
            _observations.Add(new BiasObservation
            {
                Point = point,
                Time = TimeSpan.FromSeconds(_time + (0.001 * point)),
                Column = column + (0.5 * _numbers.Gauss()),
                Row = row + (0.5 * _numbers.Gauss()),
                Position = World.ToGeodetic(reported),
                VelocityNed = velocity,
                Attitude = EulerAngles.FromRadians(
                    turned.Roll.Radians + (noise * _numbers.Gauss()), turned.Pitch.Radians + (noise * _numbers.Gauss()),
                    turned.Yaw.Radians + (noise * _numbers.Gauss())),
                Rates = rates,
                GimbalPitch = Angle.FromDegrees(-90),
            });
        }
    }

    // Columns are the camera's axes in the body: right, backward, down.
    private static double[,] Down() => new double[,] { { 0, -1, 0 }, { 1, 0, 0 }, { 0, 0, 1 } };

    private static double[,] Euler(double roll, double pitch, double yaw)
    {
        (double sr, double cr, double sp, double cp, double sy, double cy)
            = (Math.Sin(roll), Math.Cos(roll), Math.Sin(pitch), Math.Cos(pitch), Math.Sin(yaw), Math.Cos(yaw));
        return new double[,]
        {
            { cy * cp, (cy * sp * sr) - (sy * cr), (cy * sp * cr) + (sy * sr) },
            { sy * cp, (sy * sp * sr) + (cy * cr), (sy * sp * cr) - (cy * sr) },
            { -sp, cp * sr, cp * cr },
        };
    }

    private static double[,] Product(double[,] a, double[,] b)
    {
        var product = new double[3, 3];
        for (int i = 0; i < 9; i++)
            product[i / 3, i % 3] = (a[i / 3, 0] * b[0, i % 3]) + (a[i / 3, 1] * b[1, i % 3])
                + (a[i / 3, 2] * b[2, i % 3]);
        return product;
    }

    private static double Dot(double[,] m, double[] v, int column)
        => (m[0, column] * v[0]) + (m[1, column] * v[1]) + (m[2, column] * v[2]);
}
