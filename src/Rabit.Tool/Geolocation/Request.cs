using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Tool.Geolocation;

/// <summary>Pixels and all that is needed to find their places.</summary>
internal sealed class Request
{
    private const string Pose = "pose";
    private const string Pixel = "pixel";
    private const string Pixels = "pixels";
    private const string Gimbal = "gimbal";
    private const int MaxPixels = 10_000;
    public const double MaxSeconds = 1e11;   // some 3000 years: far below what a TimeSpan holds

    private readonly PixelGeolocator _locator;
    private readonly TimeSpan _time;
    private readonly ImagingCommand _command;
    private readonly Photo? _photo;
    private readonly IReadOnlyList<(double Column, double Row)> _pixels;

    private bool _isTimed;
    private string? _unusedPose;

    private Request(
        PixelGeolocator locator, TimeSpan time, ImagingCommand command,
        IReadOnlyList<(double Column, double Row)> pixels, Photo? photo = null)
        => (_locator, _time, _command, _pixels, _photo) = (locator, time, command, pixels, photo);

    /// <summary>Whether a list of pixels was asked for, though it may have one entry.</summary>
    public bool IsList { get; private set; }

    /// <exception cref="FormatException">Something is missing, unknown or of a wrong type.</exception>
    /// <exception cref="PictureException">The file describes no camera.</exception>
    public static Request Read(GeolocateOptions line, TextReader input)
    {
        if (line.IsPhoto)
            return OfPhoto(line);
        CameraFolder camera = CameraFolder.OpenFile(line.Camera);
        RequestFields request = Fields(line.Request, input);
        var options = new ImageProcessingOptions { Camera = camera.Camera, Mount = camera.Mount };
        if (line.Terrain is not null)
            options.Terrain = TerrainOf(line.Terrain);
        var locator = new PixelGeolocator(options);
        TimeSpan time = TimeSpan.FromSeconds(TimeOf(line));
        if (line.Telemetry is null)
            AddPose(locator, request.Object(Pose, [.. PoseField.All.Select(f => f.Name)]));
        else
            time = Telemetry.Read(line.Telemetry, time, locator, usesGimbal: !request.Has(Gimbal));
        return new Request(
            locator, time, CommandOf(request, options.Terrain is not null), PixelsOf(line, request, out bool isList))
        {
            IsList = isList,
            _isTimed = line.Telemetry is not null,
            _unusedPose = line.Telemetry is not null && request.Has(Pose)
                ? $"the pose of the request is not used: {line.Telemetry} says where the vehicle was"
                : null,
        };
    }

    /// <summary>What may be wrongly understood, in a line; null where nothing is.</summary>
    public string? Warning => _photo?.Warning ?? _unusedPose;

    /// <summary>Each pixel, in the order in which they were asked for.</summary>
    public IReadOnlyList<LocatedPixel> Locate() => [.. _pixels.Select(Locate)];

    private LocatedPixel Locate((double Column, double Row) pixel)
    {
        (double column, double row) = _photo?.Stored(pixel) ?? pixel;
        return new LocatedPixel(pixel.Column, pixel.Row, _locator.Locate(_time, _command, column, row), _isTimed);
    }

    private static IReadOnlyList<(double Column, double Row)> PixelsOf(
        GeolocateOptions line, RequestFields request, out bool isList)
    {
        if (request.Has(Pixel) && request.Has(Pixels))
            throw request.Fault($"{Pixel} and {Pixels} exclude each other");
        bool isGiven = line.Pixels.Count > 0;
        isList = isGiven ? line.Pixels.Count > 1 : request.Has(Pixels);
        return isGiven ? line.Pixels : isList ? request.Pairs(Pixels, MaxPixels) : [request.Pair(Pixel)];
    }

    private static Request OfPhoto(GeolocateOptions line)
    {
        var photo = new Photo(PhotoMetadata.Read(File.ReadAllBytes(line.Camera), line.Camera), line);
        TerrainGrid? terrain = line.Terrain is null ? null : TerrainOf(line.Terrain);
        PixelGeolocator locator = photo.MakeLocator(terrain, out ImagingCommand command);
        return line.Pixels.Count > 0
            ? new Request(locator, default, command, line.Pixels, photo) { IsList = line.Pixels.Count > 1 }
            : throw new FormatException("--pixel is missing: column and row of the photo.");
    }

    private static double TimeOf(GeolocateOptions line)
    {
        double seconds = line.TimeSeconds ?? 0;
        return Math.Abs(seconds) <= MaxSeconds
            ? seconds
            : throw new FormatException(
                FormattableString.Invariant($"--time is {seconds}; it must be seconds, {MaxSeconds} at most."));
    }

    private static RequestFields Fields(string? file, TextReader input)
    {
        (string text, string name) = file switch
        {
            null => ("{}", "the request"),
            "-" => (input.ReadToEnd(), "the standard input"),
            _ => (File.ReadAllText(file), file),
        };
        return RequestFields.Parse(text, name, Pose, Gimbal, PoseField.GroundAltitude.Name, Pixel, Pixels);
    }

    private static TerrainGrid TerrainOf(string file)
    {
        try
        {
            using var reader = new StreamReader(file);
            return AsciiGrid.Read(reader);
        }
        catch (Exception e) when (e is FormatException or IOException or UnauthorizedAccessException)
        {
            throw new FormatException($"{file}: {e.Message}", e);
        }
    }

    private static ImagingCommand CommandOf(RequestFields request, bool hasTerrain)
    {
        RequestFields? gimbal = request.Has(Gimbal)
            ? request.Object(Gimbal, PoseField.Roll.Name, PoseField.Pitch.Name, PoseField.Yaw.Name)
            : null;
        return new ImagingCommand
        {
            GroundAltitudeAmslMetres = request.Number(PoseField.GroundAltitude with { IsOptional = hasTerrain }),
            CameraRoll = Angle.FromDegrees(gimbal?.Number(PoseField.Roll with { IsOptional = true }) ?? 0),
            CameraPitch = Angle.FromDegrees(gimbal?.Number(PoseField.Pitch) ?? -90),
            CameraYaw = Angle.FromDegrees(gimbal?.Number(PoseField.Yaw) ?? 0),
        };
    }

    private static void AddPose(PixelGeolocator locator, RequestFields pose)
        => Telemetry.Add(locator, default, [.. PoseField.All.Select(field => pose.Number(field))]);
}
