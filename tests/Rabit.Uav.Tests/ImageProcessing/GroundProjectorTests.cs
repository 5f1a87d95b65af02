using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.Geometry;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

public sealed class GroundProjectorTests
{
    private static readonly Angle Limit = Angle.FromDegrees(5);

    [Fact]
    public void TryLocate_Vectors_FindsTheirTargetsOnFlatGround()
    {
        int located = 0;
        foreach (JsonElement c in Vectors.Geolocation.Each("flat"))
        {
            if (c.Text("status") != "ok")
                continue;
            Assert.True(
                ProjectionOf(c).TryProjectToGround(c.Number("u"), c.Number("v"), out GeodeticPosition place),
                $"case {c.Number("id")}");
            double error = Vectors.Distance(c.GetProperty("target").Position(), place);
            Assert.True(error < 1e-4, $"case {c.Number("id")} is off by {error} m");
            located++;
        }

        Assert.True(located >= 40);
    }

    [Fact]
    public void TryLocate_VectorsNearTheHorizonOrBelowGround_AreRejected()
    {
        JsonElement[] rejects = Vectors.Geolocation.Each("flat").Where(c => c.Text("status") != "ok").ToArray();
        Assert.True(rejects.Length >= 15);
        foreach (JsonElement c in rejects)
        {
            GeolocationError expected = c.Text("reason") == "camera_below_ground"
                ? GeolocationError.CameraBelowGround
                : GeolocationError.NearHorizon;
            Assert.Equal(expected, ProjectionOf(c).Locate(c.Number("u"), c.Number("v"), out NedPosition _));
        }
    }

    [Fact]
    public void Covariance_Vectors_IsTheSumOverAllErrors()
    {
        Dictionary<double, JsonElement> flat = Vectors.Geolocation.Each("flat").ToDictionary(c => c.Number("id"));
        JsonElement holder = Vectors.Geolocation.TryGetProperty("jacobian_columns", out _)
            ? Vectors.Geolocation
            : Vectors.Geolocation.Each("covariance").First();
        string[] columns = holder.Each("jacobian_columns").Select(n => n.GetString()!).ToArray();
        foreach (JsonElement c in Vectors.Geolocation.Each("covariance"))
        {
            JsonElement view = flat[c.Number("flat_case")];

            // The vectors have no error of the focal length, which comes last.
            double[] sigmas = columns.Select(n => c.GetProperty("sigma").Number(n)
                * (n.EndsWith("_deg", StringComparison.Ordinal) ? Vectors.Degree : 1)).Append(0).ToArray();
            var jacobian = new GroundJacobian(
                CameraVectors.Camera(view.GetProperty("cam").GetInt32()),
                CameraVectors.Mount(view.GetProperty("mount")));
            double[] v = c.Numbers("v_ned");
            double[] w = c.Numbers("omega_body_deg_s");
            Pose pose = PoseOf(view);
            pose.VelocityNed = new NedVector(v[0], v[1], v[2]);
            pose.Rates = BodyRates.FromDegreesPerSecond(w[0], w[1], w[2]);
            Assert.True(jacobian.TryCompute(ViewingGeometryOf(view, pose), view.Number("u"), view.Number("v")));

            HorizontalCovariance covariance = jacobian.Covariance(sigmas);

            double[] expected = c.Numbers("cov_ne");
            double tolerance = 1e-4 * (expected[0] + expected[2]);
            Assert.Equal(expected[0], covariance.NorthNorth, tolerance);
            Assert.Equal(expected[1], covariance.NorthEast, tolerance);
            Assert.Equal(expected[2], covariance.EastEast, tolerance);
        }
    }

    [Fact]
    public void Locate_ErrorOfTheFocalLength_GrowsWithTheDistanceFromTheMiddle()
    {
        var camera = new CameraModel
        {
            Width = 641,
            Height = 481,
            FocalX = 500,
            FocalY = 500,
            CentreX = 320,
            CentreY = 240,
        };
        var options = new ImageProcessingOptions { Camera = camera, Mount = new CameraMount() };
        options.Errors.FocalLengthBias = 0.03;
        double wide = EastVariance(options, 570) - EastVariance(options, 320);
        options.Errors.FocalLengthBias = 0;
        double sharp = EastVariance(options, 570) - EastVariance(options, 320);

        // 250 pixels of 500 at 40 m are 20 m, of which 3 % are 0.6 m.
        Assert.Equal(0.36, wide - sharp, 3);
        options.Errors.FocalLengthBias = -1;
        Assert.Throws<ArgumentException>(() => new PixelGeolocator(options));
    }

    [Theory]
    [InlineData(double.NaN, -90)]
    [InlineData(500, double.NaN)]
    public void Locate_HeightOfTheGroundOrAngleNotANumber_SaysSo(double groundMetres, double pitchDegrees)
    {
        var options = new ImageProcessingOptions { Camera = new TestView().Camera, Mount = new CameraMount() };
        var locator = new PixelGeolocator(options);
        locator.Add(new PoseSample
        {
            Kind = PoseSampleKind.Position,
            Position = GeodeticPosition.FromDegrees(47, 8, 540),
        });
        locator.Add(new PoseSample { Kind = PoseSampleKind.Attitude });
        var command = new ImagingCommand
        {
            CameraPitch = Angle.FromDegrees(pitchDegrees),
            GroundAltitudeAmslMetres = groundMetres,
        };

        Assert.Equal(GeolocationError.NotANumber, locator.Locate(default, command, 320, 240).Error);
    }

    private static double EastVariance(ImageProcessingOptions options, double column)
    {
        var locator = new PixelGeolocator(options);
        locator.Add(new PoseSample
        {
            Kind = PoseSampleKind.Position,
            Position = GeodeticPosition.FromDegrees(47, 8, 540),
        });
        locator.Add(new PoseSample { Kind = PoseSampleKind.Attitude });
        var command = new ImagingCommand
        {
            CameraPitch = Angle.FromDegrees(-90),
            GroundAltitudeAmslMetres = 500,
        };
        GeolocationResult result = locator.Locate(default, command, column, 240);
        Assert.Equal(GeolocationError.None, result.Error);
        return result.SystematicCovariance.EastEast;
    }

    [Fact]
    public void TryLocate_GroundPointsProjectedByTheTest_ComeBack()
    {
        const int Seed = 7;
        var random = new Random(Seed);
        var view = new TestView();
        int seen = 0;
        for (int i = 0; i < 400; i++)
        {
            view.SetAtRandom(random);
            double north = 30 * (random.NextDouble() - 0.5);
            double east = 30 * (random.NextDouble() - 0.5);
            if (!view.TryProject(north, east, out double column, out double row))
                continue;
            seen++;
            Assert.True(
                view.Projection(new ErrorBudget()).TryProjectToGround(column, row, out NedPosition ground),
                $"seed {Seed}, case {i}");
            Assert.Equal(north, ground.North, 1e-6);
            Assert.Equal(east, ground.East, 1e-6);
        }

        Assert.True(seen > 100, $"{seen} were seen");
    }

    // The middle of the picture of a camera that looks straight down, nose north (docs/managers/image-processing.md).
    [Theory]
    [InlineData(10, 0, 0, 0, 0, -1)]
    [InlineData(0, 10, 0, 0, 1, 0)]
    [InlineData(0, 0, 100, 0, 0, 1)]
    [InlineData(0, 0, 0, 100, -1, 0)]
    public void TryLocate_StraightDownNoseNorth_MovesAsTheQuickSignCheckSays(
        double roll, double pitch, double columns, double rows, int north, int east)
    {
        var view = new TestView { Attitude = EulerAngles.FromDegrees(roll, pitch, 0) };
        Assert.True(
            view.Projection(new ErrorBudget())
                .TryProjectToGround(view.Camera.CentreX + columns, view.Camera.CentreY + rows, out NedPosition ground));
        Assert.Equal((north, east), (Sign(ground.North), Sign(ground.East)));

        static int Sign(double metres) => Math.Abs(metres) < 2 ? 0 : Math.Sign(metres);
    }

    [Fact]
    public void Scale_StraightDown_IsHeightOverFocalLength()
    {
        var view = new TestView();
        Assert.True(
            view.Projection(new ErrorBudget())
                .TryScale(view.Camera.CentreX, view.Camera.CentreY, out GroundScale scale));
        double expected = view.HeightMetres / 530;
        Assert.Equal(expected * expected, scale.PixelArea, 1e-7);

        // Yaw 0 and looking down: right is east, down in the picture is south.
        Assert.Equal(expected, scale.EastByColumn, 1e-6);
        Assert.Equal(-expected, scale.NorthByRow, 1e-6);
    }

    [Fact]
    public void SetTimeNoise_OfAPicture_IsAddedToThatOfTheBudget()
    {
        var view = new TestView { Velocity = new NedVector(10, 0, 0) };
        GroundProjector projector = new(
            view.Camera, view.Mount, new ErrorBudget { TimeNoise = TimeSpan.FromMilliseconds(30) },
            Angle.FromDegrees(5));
        var pose = new Pose
        {
            Position = view.Position,
            Attitude = Rotation.Identity,
            VelocityNed = view.Velocity,
        };

        projector.SetTimeNoise(TimeSpan.FromMilliseconds(40));
        double with = NorthVariance();
        projector.SetTimeNoise(TimeSpan.Zero);
        double without = NorthVariance();

        // 50 ms instead of 30 ms at 10 m/s.
        Assert.Equal((0.5 * 0.5) - (0.3 * 0.3), with - without, 1e-6);

        double NorthVariance()
        {
            Assert.True(projector.At(pose, view.Order).TryCovariances(
                view.Camera.CentreX, view.Camera.CentreY, out HorizontalCovariance random, out _));
            return random.NorthNorth;
        }
    }

    [Fact]
    public void Covariances_ErrorsDrawnAtRandom_SpreadAsStated()
    {
        const int Seed = 11;
        const int Draws = 4000;
        var random = new Random(Seed);
        var budget = new ErrorBudget
        {
            AttitudeNoise = Angle.FromDegrees(0.5),
            HeadingNoise = Angle.FromDegrees(1.5),
            PositionNoiseMetres = 0.4,
            AltitudeNoiseMetres = 0.6,
            PixelNoise = 0.8,
            TimeNoise = TimeSpan.FromMilliseconds(30),
            PositionBiasMetres = 0,
            AttitudeBias = Angle.Zero,
            HeadingBias = Angle.Zero,
            MountBias = Angle.Zero,
            AltitudeBiasMetres = 0,
        };
        var view = new TestView
        {
            Attitude = EulerAngles.FromRadians(0.1, -0.15, 0.7),
            Velocity = new NedVector(6, -3, 0.5),
            Rates = BodyRates.FromRadiansPerSecond(0.2, -0.1, 0.1)
        };
        GroundProjection projection = view.Projection(budget);
        const double Column = 480;
        const double Row = 120;
        Assert.True(projection.TryProjectToGround(Column, Row, out NedPosition truth));
        Assert.True(
            projection.TryCovariances(Column, Row, out HorizontalCovariance stated, out HorizontalCovariance common));
        Assert.Equal(0, common.NorthNorth + common.EastEast);

        (double nn, double ne, double ee) = (0, 0, 0);
        for (int i = 0; i < Draws; i++)
        {
            NedPosition ground = view.WithErrors(random, budget)
                .Located(Column + (budget.PixelNoise * Gauss(random)), Row + (budget.PixelNoise * Gauss(random)));
            (double north, double east) = (ground.North - truth.North, ground.East - truth.East);
            nn += north * north / Draws;
            ne += north * east / Draws;
            ee += east * east / Draws;
        }

        // The spread of a variance over so many draws is 2.2 %.
        double tolerance = 0.08 * (stated.NorthNorth + stated.EastEast);
        Assert.Equal(nn, stated.NorthNorth, tolerance);
        Assert.Equal(ne, stated.NorthEast, tolerance);
        Assert.Equal(ee, stated.EastEast, tolerance);
    }

    [Fact]
    public void Covariances_DefaultErrors_AreThoseOfAnUncalibratedVehicle()
    {
        Assert.True(
            new TestView().Projection(new ErrorBudget())
                .TryCovariances(320, 240, out HorizontalCovariance perLook, out HorizontalCovariance common));
        Assert.InRange(perLook.HalfMajorAxis95Metres, 0.5, 2);
        Assert.InRange(common.HalfMajorAxis95Metres, 2.5, 4.5);
    }

    // 0.2 s at 6 m/s, along the flight and nowhere else; the random covariance knows nothing of it.
    [Fact]
    public void Covariances_TimesOfPosesUncertain_AddSpeedTimesThatAlongTheFlight()
    {
        var view = new TestView { Velocity = new NedVector(6, 0, 0) };
        Assert.True(view.Projection(new ErrorBudget())
            .TryCovariances(320, 240, out HorizontalCovariance random, out HorizontalCovariance without));
        view.TimeErrorSeconds = 0.2;
        Assert.True(view.Projection(new ErrorBudget())
            .TryCovariances(320, 240, out HorizontalCovariance same, out HorizontalCovariance with));
        Assert.Equal(1.2 * 1.2, with.NorthNorth - without.NorthNorth, 1e-3);
        Assert.Equal(0, with.EastEast - without.EastEast, 1e-6);
        Assert.Equal(random.NorthNorth, same.NorthNorth);
    }

    internal static double Gauss(Random random)
        => Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());

    internal static Pose PoseOf(JsonElement view)
        => new() { Position = view.Position(), Attitude = Rotation.FromEuler(view.Euler()) };

    internal static GroundProjection ProjectionOf(
        JsonElement view, TerrainGrid? terrain = null, ErrorBudget? errors = null)
    {
        JsonElement mount = view.GetProperty("mount");
        var projector = new GroundProjector(
            CameraVectors.Camera(view.GetProperty("cam").GetInt32()), CameraVectors.Mount(mount),
            errors ?? new ErrorBudget(), Limit, terrain);
        return projector.At(PoseOf(view), new ImagingCommand
        {
            CameraPitch = Angle.FromRadians(mount.Radians("el")),
            CameraYaw = Angle.FromRadians(mount.Radians("az")),
            GroundAltitudeAmslMetres = terrain is null ? view.Number("ground_h") : 0,
        });
    }

    private static ViewingGeometry ViewingGeometryOf(JsonElement view, Pose pose) => new()
    {
        Pose = pose,
        Gimbal = GimbalAttitude.AgainstBody(
            Angle.FromRadians(view.GetProperty("mount").Radians("el")),
            Angle.FromRadians(view.GetProperty("mount").Radians("az"))),
        GroundDownMetres = view.Number("h") - view.Number("ground_h"),
    };
}
