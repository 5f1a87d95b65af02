using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// A camera over flat ground, and the way from the ground to its picture, written down once more by matrices, so that a
/// wrong sign in the product cannot cancel. The origin is the vehicle.
/// </summary>
internal sealed class TestView
{
    public CameraModel Camera { get; } = new()
    {
        Width = 640,
        Height = 480,
        FocalX = 530,
        FocalY = 530,
        CentreX = 320,
        CentreY = 240,
        K1 = -0.05,
        K2 = 0.01,
        P1 = 0.0005,
        P2 = -0.0003,
    };

    public CameraMount Mount { get; } = new() { GimbalLeverArmMetres = new BodyVector(0.1, 0, 0.05) };

    public GeodeticPosition Position { get; set; } = GeodeticPosition.FromRadians(0.8, 0.15, 540);

    public double GroundAltitude { get; set; } = 500;

    public double HeightMetres => Position.AltitudeAmslMetres - GroundAltitude - Mount.GimbalLeverArmMetres.Down;

    public EulerAngles Attitude { get; set; }

    public NedVector Velocity { get; set; }

    public BodyRates Rates { get; set; }

    public double TimeErrorSeconds { get; set; }

    public double CameraPitch { get; set; } = -Math.PI / 2;

    public double CameraYaw { get; set; }

    public ImagingCommand Order => new()
    {
        Mode = ImagingMode.Search,
        CameraPitch = Angle.FromRadians(CameraPitch),
        CameraYaw = Angle.FromRadians(CameraYaw),
        GroundAltitudeAmslMetres = GroundAltitude,
    };

    public void SetAtRandom(Random random)
    {
        Attitude = EulerAngles.FromRadians(Spread(0.5), Spread(0.5), Spread(Math.PI));
        CameraPitch = (-Math.PI / 2) + Spread(0.5);
        CameraYaw = Spread(1);
        Position = GeodeticPosition.FromRadians(
            Spread(1.5), Spread(Math.PI), GroundAltitude + 20 + (random.NextDouble() * 60));

        double Spread(double most) => ((2 * random.NextDouble()) - 1) * most;
    }

    public GroundProjection Projection(ErrorBudget budget)
    {
        var projector = new GroundProjector(Camera, Mount, budget, Angle.FromDegrees(5));
        return projector.At(
            new Pose
            {
                Position = Position,
                Attitude = Rotation.FromEuler(Attitude),
                VelocityNed = Velocity,
                TimeErrorSeconds = TimeErrorSeconds,
                Rates = Rates
            },
            Order);
    }

    /// <summary>Where a point of the ground is seen; false if it is not in the picture.</summary>
    public bool TryProject(double north, double east, out double column, out double row)
    {
        double[,] nedFromBody = Times(
            Times(AboutZ(Attitude.Yaw.Radians), AboutY(Attitude.Pitch.Radians)), AboutX(Attitude.Roll.Radians));
        double[,] bodyFromGimbal = Times(AboutZ(CameraYaw), AboutY(CameraPitch));
        BodyVector arm = Mount.GimbalLeverArmMetres;
        double[] armNed = Times(nedFromBody, [arm.Forward, arm.Right, arm.Down]);
        double down = Position.AltitudeAmslMetres - GroundAltitude;
        double[] body = TimesTransposed(nedFromBody, [north - armNed[0], east - armNed[1], down - armNed[2]]);
        double[] gimbal = TimesTransposed(bodyFromGimbal, body);
        (double x, double y, double z) = (gimbal[1], gimbal[2], gimbal[0]);
        (column, row) = (double.NaN, double.NaN);
        if (z < 0.1)
            return false;
        (x, y) = (x / z, y / z);
        double r2 = (x * x) + (y * y);
        if (r2 > 0.7)
            return false;
        double gain = 1 + (Camera.K1 * r2) + (Camera.K2 * r2 * r2);
        column = (Camera.FocalX * ((x * gain) + (2 * Camera.P1 * x * y) + (Camera.P2 * (r2 + (2 * x * x)))))
            + Camera.CentreX;
        row = (Camera.FocalY * ((y * gain) + (Camera.P1 * (r2 + (2 * y * y))) + (2 * Camera.P2 * x * y)))
            + Camera.CentreY;
        return column >= 0 && column <= Camera.Width - 1 && row >= 0 && row <= Camera.Height - 1;
    }

    /// <summary>A point of the ground from the vehicle, in the frame of its body.</summary>
    public BodyVector ToBody(double north, double east)
    {
        double[,] nedFromBody = Times(
            Times(AboutZ(Attitude.Yaw.Radians), AboutY(Attitude.Pitch.Radians)), AboutX(Attitude.Roll.Radians));
        double[] body = TimesTransposed(
            nedFromBody, [north, east, Position.AltitudeAmslMetres - GroundAltitude]);
        return new BodyVector(body[0], body[1], body[2]);
    }

    /// <summary>The same view as the product would see it with errors drawn from a budget.</summary>
    public TestView WithErrors(Random random, ErrorBudget budget)
    {
        double late = budget.TimeNoise.TotalSeconds * Draw();
        Rotation turned = Rotation.FromEuler(EulerAngles.FromRadians(
            Attitude.Roll.Radians + (budget.AttitudeNoise.Radians * Draw()),
            Attitude.Pitch.Radians + (budget.AttitudeNoise.Radians * Draw()),
            Attitude.Yaw.Radians + (budget.HeadingNoise.Radians * Draw()))).After(Rates, late);
        _offset = new NedVector(
            (budget.PositionNoiseMetres * Draw()) + (Velocity.North * late),
            (budget.PositionNoiseMetres * Draw()) + (Velocity.East * late), 0);
        double up = (budget.AltitudeNoiseMetres * Draw()) - (Velocity.Down * late);
        return new TestView
        {
            Attitude = turned.ToEuler(),
            Position = GeodeticPosition.FromRadians(
                Position.Latitude.Radians, Position.Longitude.Radians, Position.AltitudeAmslMetres + up),
            _offset = _offset,
        };

        double Draw() => GroundProjectorTests.Gauss(random);
    }

    /// <summary>Where a pixel is, from the vehicle without its errors.</summary>
    public NedPosition Located(double column, double row)
    {
        if (!Projection(new ErrorBudget()).TryProjectToGround(column, row, out NedPosition ground))
            throw new InvalidOperationException("The pixel does not show the ground.");
        return ground + _offset;
    }

    private NedVector _offset;

    private static double[,] AboutX(double a)
        => new[,] { { 1, 0, 0 }, { 0, Math.Cos(a), -Math.Sin(a) }, { 0, Math.Sin(a), Math.Cos(a) } };

    private static double[,] AboutY(double a)
        => new[,] { { Math.Cos(a), 0, Math.Sin(a) }, { 0, 1, 0 }, { -Math.Sin(a), 0, Math.Cos(a) } };

    private static double[,] AboutZ(double a)
        => new[,] { { Math.Cos(a), -Math.Sin(a), 0 }, { Math.Sin(a), Math.Cos(a), 0 }, { 0, 0, 1 } };

    private static double[,] Times(double[,] a, double[,] b)
    {
        var product = new double[3, 3];
        for (int i = 0; i < 3; i++)
        {
            for (int j = 0; j < 3; j++)
                product[i, j] = (a[i, 0] * b[0, j]) + (a[i, 1] * b[1, j]) + (a[i, 2] * b[2, j]);
        }

        return product;
    }

    private static double[] Times(double[,] a, double[] v)
        => [(a[0, 0] * v[0]) + (a[0, 1] * v[1]) + (a[0, 2] * v[2]),
            (a[1, 0] * v[0]) + (a[1, 1] * v[1]) + (a[1, 2] * v[2]),
            (a[2, 0] * v[0]) + (a[2, 1] * v[1]) + (a[2, 2] * v[2])];

    private static double[] TimesTransposed(double[,] a, double[] v)
        => [(a[0, 0] * v[0]) + (a[1, 0] * v[1]) + (a[2, 0] * v[2]),
            (a[0, 1] * v[0]) + (a[1, 1] * v[1]) + (a[2, 1] * v[2]),
            (a[0, 2] * v[0]) + (a[1, 2] * v[1]) + (a[2, 2] * v[2])];
}
