using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Camera;

/// <summary>
/// Where panels are seen in pictures, against the projection of OpenCV's documentation with rotation matrices, written
/// out here.
/// </summary>
public class ProjectionTests(ITestOutputHelper output)
{
    private static readonly CameraModel Bent = new()
    {
        Width = 320,
        Height = 240,
        FocalX = 265,
        FocalY = 260,
        CentreX = 162.5,
        CentreY = 117.25,
        K1 = -0.21,
        K2 = 0.07,
        P1 = 0.0012,
        P2 = -0.0009,
        K3 = -0.008,
    };

    [Fact]
    public void Rays_ThroughTheLens_FallOnTheirPixels()
    {
        var lens = new LensRays(Bent);
        for (int v = 0; v < Bent.Height; v++)
        {
            for (int u = 0; u < Bent.Width; u++)
            {
                int at = ((v * Bent.Width) + u) * 2;
                (double atU, double atV) = Project(Bent, lens.Rays[at], lens.Rays[at + 1], 1);
                if (Math.Abs(atU - u) > 1e-9 || Math.Abs(atV - v) > 1e-9)
                    Assert.Fail($"the ray of pixel ({u}, {v}) falls on ({atU}, {atV})");
            }
        }
    }

    [Fact]
    public void Rays_FoldedLens_IsRefused()
    {
        var folded = new CameraModel
        {
            Width = 320,
            Height = 240,
            FocalX = 150,
            FocalY = 150,
            CentreX = 160,
            CentreY = 120,
            K1 = -0.9
        };

        Assert.Contains(
            "no ray of light falls on pixel", Assert.Throws<ArgumentException>(() => new LensRays(folded)).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Panels_AnyPoseAndLens_AreWhereTheFormulaSays()
    {
        const int Seed = 5;
        output.WriteLine($"seed {Seed}");
        var random = new Random(Seed);
        var scene = new Scene(new SimulatedCameraOptions
        {
            Camera = Bent,
            LeverArmForwardMetres = 0.3,
            LeverArmRightMetres = -0.2,
            LeverArmDownMetres = 0.4,
            MisalignmentRoll = Angle.FromRadians(0.03),
            MisalignmentPitch = Angle.FromRadians(-0.05),
            MisalignmentYaw = Angle.FromRadians(0.08),
        });
        int seen = 0;
        double worst = 0;
        for (int run = 0; run < 600; run++)
        {
            TruePose pose = Scene.Pose(
                20 + (60 * random.NextDouble()), Spread(random, 35), Spread(random, 35), Spread(random, 400),
                -90 + (50 * random.NextDouble()), Spread(random, 180));
            pose.Position = pose.Position with { North = Spread(random, 500), East = Spread(random, 500) };
            (double north, double east) = GroundBelow(pose, random);
            var panel = Scene.Panel(north, east, heading: Spread(random, 3), side: 0.6);
            (double wantedU, double wantedV, double depth) = Expected(pose, panel.Position.North, panel.Position.East);
            if (depth < 10 || depth > 120 || wantedU is < 10 or > 309 || wantedV is < 10 or > 229)
                continue;

            (double u, double v, double pixels) = scene.Find(pose, panel);

            seen++;
            double miss = Math.Sqrt(Math.Pow(u - wantedU, 2) + Math.Pow(v - wantedV, 2));
            worst = Math.Max(worst, miss);
            Assert.True(
                pixels > 0 && miss < 0.35,
                $"run {run}: wanted ({wantedU:F2}, {wantedV:F2}), found ({u:F2}, {v:F2}) on {pixels:F1} pixels");
        }

        output.WriteLine($"{seen} seen, worst {worst:F3} px");
        Assert.InRange(seen, 100, 600);
    }

    [Fact]
    public void Panel_CameraTurnsDuringTheExposure_IsSmearedAboutItsMiddle()
    {
        var scene = new Scene();
        TruePose middle = Scene.Pose(40);
        TruePose early = Scene.Pose(40, pitch: -0.5);
        TruePose late = Scene.Pose(40, pitch: 0.5);
        SimulatedTarget panel = Scene.Panel(0, 0);

        (double u, double v, double pixels) = scene.Find(middle, early, late, panel);

        // 1 degree is 4.6 px, the panel 6.6 px: two of it that overlap in the 2 px in the middle.
        Assert.Equal(160, u, 0.1);
        Assert.Equal(120, v, 0.1);
        Assert.Equal(Math.Pow(265 / 40.0, 2), pixels, 1.5);
        Assert.InRange(Red(scene, 160, 120), Red(scene, 160, 120 + 4) + 20, 255);
        Assert.InRange(Red(scene, 160, 120 + 4), Red(scene, 160, 120 + 8) + 20, 255);
    }

    private static double Red(Scene scene, int u, int v) => scene.LastPicture[((v * 320) + u) * 3];

    private static (double North, double East) GroundBelow(in TruePose pose, Random random)
        => (pose.Position.North + Spread(random, -pose.Position.Down),
            pose.Position.East + Spread(random, -pose.Position.Down));

    private static double Spread(Random random, double most) => ((2 * random.NextDouble()) - 1) * most;

    private static (double U, double V, double Depth) Expected(in TruePose pose, double north, double east)
    {
        double[,] body = Euler(pose.Attitude.Yaw.Radians, pose.Attitude.Pitch.Radians, pose.Attitude.Roll.Radians);
        double[,] gimbal = Times(
            body, Times(Euler(0.08, -0.05, 0.03), Euler(pose.CameraYaw.Radians, pose.CameraPitch.Radians, 0)));
        double[] arm = Apply(body, [0.3, -0.2, 0.4]);
        double[] way =
            [north - pose.Position.North - arm[0], east - pose.Position.East - arm[1], -pose.Position.Down - arm[2]];
        // right, down, along the axis
        (double x, double y, double z) = (Column(gimbal, 1, way), Column(gimbal, 2, way), Column(gimbal, 0, way));

        // Far beyond the edge of the picture the formula of the lens folds back into it; no lens does.
        bool isBeforeTheLens = z > 0 && (x * x) + (y * y) < z * z;
        (double u, double v) = isBeforeTheLens ? Project(Bent, x, y, z) : (-1, -1);
        return (u, v, z);
    }

    private static (double U, double V) Project(CameraModel c, double x, double y, double z)
    {
        (x, y) = (x / z, y / z);
        double r2 = (x * x) + (y * y);
        double radial = 1 + (c.K1 * r2) + (c.K2 * r2 * r2) + (c.K3 * r2 * r2 * r2);
        double bentX = (x * radial) + (2 * c.P1 * x * y) + (c.P2 * (r2 + (2 * x * x)));
        double bentY = (y * radial) + (c.P1 * (r2 + (2 * y * y))) + (2 * c.P2 * x * y);
        return ((c.FocalX * bentX) + c.CentreX, (c.FocalY * bentY) + c.CentreY);
    }

    private static double[,] Euler(double yaw, double pitch, double roll)
    {
        double[,] z = { { Math.Cos(yaw), -Math.Sin(yaw), 0 }, { Math.Sin(yaw), Math.Cos(yaw), 0 }, { 0, 0, 1 } };
        double[,] y =
        {
            { Math.Cos(pitch), 0, Math.Sin(pitch) },
            { 0, 1, 0 },
            { -Math.Sin(pitch), 0, Math.Cos(pitch) }
        };
        double[,] x = { { 1, 0, 0 }, { 0, Math.Cos(roll), -Math.Sin(roll) }, { 0, Math.Sin(roll), Math.Cos(roll) } };
        return Times(z, Times(y, x));
    }

    private static double[,] Times(double[,] a, double[,] b)
    {
        double[,] product = new double[3, 3];
        for (int row = 0; row < 3; row++)
        {
            for (int column = 0; column < 3; column++)
                product[row, column] = (a[row, 0] * b[0, column]) + (a[row, 1] * b[1, column])
                    + (a[row, 2] * b[2, column]);
        }

        return product;
    }

    private static double[] Apply(double[,] m, double[] v)
        => [(m[0, 0] * v[0]) + (m[0, 1] * v[1]) + (m[0, 2] * v[2]),
            (m[1, 0] * v[0]) + (m[1, 1] * v[1]) + (m[1, 2] * v[2]),
            (m[2, 0] * v[0]) + (m[2, 1] * v[1]) + (m[2, 2] * v[2])];

    private static double Column(double[,] m, int column, double[] v)
        => (m[0, column] * v[0]) + (m[1, column] * v[1]) + (m[2, column] * v[2]);
}
