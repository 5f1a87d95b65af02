using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Tool.Geolocation;

/// <summary>
/// A photo that says by itself where its camera was and how it was turned: a pinhole without distortion, whose angles
/// are against horizon and north. What the command line says comes first.
/// </summary>
internal sealed class Photo
{
    private const double FocalLengthErrorBySensor = 0.01;

    private readonly PhotoMetadata _said;
    private readonly GeolocateOptions _line;
    private readonly List<string> _missing = [];

    public Photo(PhotoMetadata said, GeolocateOptions line)
        => (_said, _line) = (said, line);

    /// <summary>What may be wrongly understood of its pixels, in a line; null where nothing is.</summary>
    public string? Warning => _said.Orientation is { } orientation and >= 2 and <= 8
        ? FormattableString.Invariant(
            $"{_line.Camera}: viewers show it turned (EXIF orientation {orientation}); pixels are those of the stored picture, before it is turned")
        : null;

    /// <summary>A locator of its pixels.</summary>
    /// <exception cref="FormatException">Something is missing; the text names all of it.</exception>
    public PixelGeolocator MakeLocator(TerrainGrid? terrain, out ImagingCommand command)
    {
        double latitude = Find("latitude", _said.LatitudeDegrees, "its latitude");
        double longitude = Find("longitude", _said.LongitudeDegrees, "its longitude");
        double altitude = Find("altitude", _said.AltitudeAmslMetres ?? _said.AbsoluteAltitudeMetres, "its altitude");
        double? ground = terrain is null ? GroundOf(altitude) : null;
        double pitch = Find("camera-pitch", _said.GimbalPitchDegrees, "the pitch of its camera");
        double? direction = _said.IsImageDirectionMagnetic ? null : _said.ImageDirectionDegrees;
        double yaw = Find("camera-yaw", _said.GimbalYawDegrees ?? direction, "the yaw of its camera");
        double roll = Given("camera-roll") ?? _said.GimbalRollDegrees ?? 0;
        CameraModel camera = CameraOf();
        if (_missing.Count > 0)
            throw new FormatException($"{_line.Camera} does not say {string.Join(", ", _missing)}.{NotUnderstood}");

        var options = new ImageProcessingOptions
        {
            Camera = camera,
            Mount = new CameraMount { FixedBodyFromCamera = FromCamera(roll, pitch, yaw) },
            Terrain = terrain,
        };

        // The angles are those of the camera itself, on a gimbal that levels it: there is no mount between them.
        options.Errors.AttitudeNoise = Angle.FromDegrees(0.3);
        options.Errors.AttitudeBias = Angle.FromDegrees(0.4);
        options.Errors.MountBias = Angle.Zero;
        var locator = new PixelGeolocator(options);
        Telemetry.Add(locator, default, [latitude, longitude, altitude, 0, 0, 0, 0, 0, 0]);
        command = new ImagingCommand { GroundAltitudeAmslMetres = ground ?? 0 };
        return locator;
    }

    /// <summary>A pixel as it was when the photo was taken.</summary>
    public (double Column, double Row) Stored((double Column, double Row) pixel) => _line.IsTurned
        ? (_said.Width!.Value - 1 - pixel.Column, _said.Height!.Value - 1 - pixel.Row)
        : pixel;

    // The body is a level one that points north; from the camera to the gimbal's axes by a turn about (1, 1, 1).
    private static Rotation FromCamera(double roll, double pitch, double yaw)
        => Rotation.FromEuler(EulerAngles.FromDegrees(roll, pitch, yaw)) * Rotation.FromQuaternion(1, 1, 1, 1);

    private double? GroundOf(double altitude)
    {
        if (Given("ground-altitude") is { } ground)
            return ground;
        return altitude - Find(
            "height", _said.RelativeAltitudeMetres, "its height above the ground", "--height or --ground-altitude");
    }

    private CameraModel CameraOf()
    {
        (int width, int height) = (_said.Width ?? 0, _said.Height ?? 0);
        if (width == 0 || height == 0)
            _missing.Add("its size");
        if (UsesLens && _said.Lens is { } lens)
            return CameraOf(lens, width, height);
        int longSide = Math.Max(width, height);
        double error = FocalLengthErrorBySensor;
        double pixels;
        if (Given("sensor-width") is { } sensor)
        {
            pixels = FocalLength.FromSensor(
                longSide, Find("focal-length", _said.FocalLengthMillimetres, "its focal length"), sensor);
        }
        else if (Given("focal-length-35mm") is null && _said.FocalLengthPixels is { } calibrated)
        {
            // Of the picture as it was taken, which may have been made smaller since.
            pixels = calibrated * longSide / Math.Max(_said.PixelWidth ?? width, _said.PixelHeight ?? height);
        }
        else
        {
            double equivalent = Find(
                "focal-length-35mm", _said.FocalLength35MillimetreEquivalentMillimetres, "its focal length",
                "--focal-length-35mm, or --focal-length and --sensor-width");
            pixels = FocalLength.From35MillimetreEquivalent(longSide, equivalent);
            error = FocalLength.ErrorOf35MillimetreEquivalent(equivalent);
        }

        return new CameraModel
        {
            Width = width,
            Height = height,
            FocalX = pixels,
            FocalY = pixels,
            FocalLengthError = error,
            CentreX = (width - 1) / 2.0,
            CentreY = (height - 1) / 2.0,
        };
    }

    // Where the focal length is given, the photo's is not trusted, nor is its lens.
    private bool UsesLens => Given("sensor-width") is null && Given("focal-length-35mm") is null;

    // Of the picture as it was taken, which may have been made smaller since.
    private CameraModel CameraOf(PhotoLens lens, int width, int height)
    {
        double scale = (double)Math.Max(width, height)
            / Math.Max(_said.PixelWidth ?? width, _said.PixelHeight ?? height);
        return new CameraModel
        {
            Width = width,
            Height = height,
            FocalX = scale * lens.FocalX,
            FocalY = scale * lens.FocalY,
            FocalLengthError = FocalLengthErrorBySensor,
            CentreX = ((width - 1) / 2.0) + (scale * lens.CentreOffsetX),
            CentreY = ((height - 1) / 2.0) + (scale * lens.CentreOffsetY),
            K1 = lens.K1,
            K2 = lens.K2,
            P1 = lens.P1,
            P2 = lens.P2,
            K3 = lens.K3,
        };
    }

    private string NotUnderstood
        => _said.Faults.Count == 0 ? "" : $" What was not understood: {string.Join("; ", _said.Faults)}.";

    private double Find(string option, double? said, string what, string? options = null)
    {
        if ((Given(option) ?? said) is { } value)
            return value;
        _missing.Add($"{what} ({options ?? "--" + option})");
        return double.NaN;
    }

    private double? Given(string option) => _line.OfPhoto.TryGetValue(option, out double value) ? value : null;
}
