using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Geometry;

/// <summary>Gimbals against body, horizon and north, 100 m above level ground.</summary>
public sealed class GimbalTests
{
    private const double HeightMetres = 100;
    private static readonly GeodeticPosition Vehicle = GeodeticPosition.FromDegrees(47, 8, 500 + HeightMetres);

    private static readonly CameraModel Camera = new()
    {
        Width = 641,
        Height = 481,
        FocalX = 500,
        FocalY = 500,
        CentreX = 320,
        CentreY = 240,
    };

    [Theory]
    [InlineData(GimbalFrame.Body, -68.1, 30)]
    [InlineData(GimbalFrame.Heading, -60, 30)]
    [InlineData(GimbalFrame.North, -60, 0)]
    public void Locate_TiltedVehicle_LooksWhereTheFrameOfTheGimbalSays(
        GimbalFrame frame, double pitchDegrees, double azimuthDegrees)
    {
        NedPosition place = Locate(frame, -60, 0, EulerAngles.FromDegrees(0, -8.1, 30), 320, 240, out _);

        double distance = HeightMetres / Math.Tan(-pitchDegrees * Angle.RadiansPerDegree);
        Assert.Equal(distance * Math.Cos(azimuthDegrees * Angle.RadiansPerDegree), place.North, 1e-3);
        Assert.Equal(distance * Math.Sin(azimuthDegrees * Angle.RadiansPerDegree), place.East, 1e-3);
    }

    [Fact]
    public void Locate_YawAgainstNorth_DoesNotTurnWithTheVehicle()
    {
        NedPosition place = Locate(GimbalFrame.North, -45, 90, EulerAngles.FromDegrees(10, 5, -70), 320, 240, out _);

        Assert.Equal(0, place.North, 1e-3);
        Assert.Equal(HeightMetres, place.East, 1e-2);
    }

    [Fact]
    public void Locate_VehicleLevel_IsTheSameAgainstBodyAndHeading()
    {
        var attitude = EulerAngles.FromDegrees(0, 0, 77);
        NedPosition body = Locate(GimbalFrame.Body, -50, 20, attitude, 100, 400, out _);
        NedPosition heading = Locate(GimbalFrame.Heading, -50, 20, attitude, 100, 400, out _);

        Assert.Equal(0, body.DistanceTo(heading), 1e-6);
    }

    [Fact]
    public void Locate_RollOfTheGimbal_TurnsThePicture()
    {
        var locator = new PixelGeolocator(Options(GimbalFrame.Body));
        AddPose(locator, default);
        locator.Add(new PoseSample
        {
            Kind = PoseSampleKind.Gimbal,
            Gimbal = new GimbalAttitude(EulerAngles.FromDegrees(90, -90, 0), GimbalFrame.Heading),
        });

        // Straight down with the top forward, then right side down: what is right in the picture is behind.
        NedPosition place = Place(locator.Locate(default, Command(-90, 0), 420, 240));
        Assert.Equal(-20, place.North, 1e-3);
        Assert.Equal(0, place.East, 1e-3);
    }

    [Fact]
    public void Locate_GimbalThatReports_IsUsedInsteadOfTheCommand()
    {
        var locator = new PixelGeolocator(Options(GimbalFrame.Body));
        AddPose(locator, EulerAngles.FromDegrees(0, -20, 0));
        locator.Add(new PoseSample
        {
            Kind = PoseSampleKind.Gimbal,
            Gimbal = new GimbalAttitude(EulerAngles.FromDegrees(0, -45, 0), GimbalFrame.Heading),
        });

        NedPosition place = Place(locator.Locate(default, Command(-90, 0), 320, 240));
        Assert.Equal(HeightMetres, place.North, 1e-2);
    }

    [Fact]
    public void Locate_FixedCamera_IgnoresAGimbal()
    {
        ImageProcessingOptions options = Options(GimbalFrame.Heading);
        options.Mount = new CameraMount { FixedBodyFromCamera = Rotation.FromMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1) };
        var locator = new PixelGeolocator(options);
        AddPose(locator, default);
        locator.Add(new PoseSample
        {
            Kind = PoseSampleKind.Gimbal,
            Gimbal = new GimbalAttitude(EulerAngles.FromDegrees(0, -45, 0), GimbalFrame.Heading),
        });

        NedPosition place = Place(locator.Locate(default, Command(-45, 0), 320, 240));
        Assert.Equal(0, place.North, 1e-3);
    }

    [Fact]
    public void Locate_StabilisedGimbal_IsNotWrongByTheAttitudeOfTheVehicle()
    {
        Locate(GimbalFrame.Body, -90, 0, default, 320, 240, out HorizontalCovariance body);
        Locate(GimbalFrame.Heading, -90, 0, default, 320, 240, out HorizontalCovariance heading);

        // 0.7 degrees of attitude, and 0.3 of the mount that stays.
        double byAttitude = HeightMetres * 0.7 * Angle.RadiansPerDegree;
        Assert.Equal(byAttitude * byAttitude, body.NorthNorth - heading.NorthNorth, 1e-2);
        Assert.True(heading.NorthNorth > Math.Pow(HeightMetres * 0.3 * Angle.RadiansPerDegree, 2));
    }

    [Fact]
    public void At_LeverArms_FollowTheFrame()
    {
        var mount = new CameraMount
        {
            GimbalLeverArmMetres = new BodyVector(0.2, 0, 0.1),
            CameraLeverArmMetres = new BodyVector(0.05, 0, 0),
        };
        Rotation attitude = Rotation.FromEuler(EulerAngles.FromDegrees(0, 30, 0));
        var down = new GimbalAttitude(EulerAngles.FromDegrees(0, -90, 0), GimbalFrame.Heading);

        // Down along the horizon's down, which in a body whose nose is 30 degrees up is to the back.
        BodyVector at = mount.At(down, attitude).PositionMetres;
        Assert.Equal(0.2 - (0.05 * Math.Sin(30 * Angle.RadiansPerDegree)), at.Forward, 1e-9);
        Assert.Equal(0.1 + (0.05 * Math.Cos(30 * Angle.RadiansPerDegree)), at.Down, 1e-9);
    }

    private static NedPosition Locate(
        GimbalFrame frame, double pitchDegrees, double yawDegrees, EulerAngles attitude, double column, double row,
        out HorizontalCovariance systematic)
    {
        var locator = new PixelGeolocator(Options(frame));
        AddPose(locator, attitude);
        GeolocationResult result = locator.Locate(default, Command(pitchDegrees, yawDegrees), column, row);
        systematic = result.SystematicCovariance;
        return Place(result);
    }

    private static ImageProcessingOptions Options(GimbalFrame frame)
        => new() { Camera = Camera, Mount = new CameraMount { GimbalFrame = frame } };

    private static ImagingCommand Command(double pitchDegrees, double yawDegrees) => new()
    {
        CameraPitch = Angle.FromDegrees(pitchDegrees),
        CameraYaw = Angle.FromDegrees(yawDegrees),
        GroundAltitudeAmslMetres = 500,
    };

    private static void AddPose(PixelGeolocator locator, EulerAngles attitude)
    {
        locator.Add(new PoseSample { Kind = PoseSampleKind.Position, Position = Vehicle });
        locator.Add(new PoseSample { Kind = PoseSampleKind.Attitude, Attitude = attitude });
    }

    private static NedPosition Place(in GeolocationResult result)
    {
        Assert.Equal(GeolocationError.None, result.Error);
        return LocalNedFrame.IgnoringGeoid(Vehicle).ToNed(result.Position);
    }
}
