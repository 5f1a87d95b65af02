using System;
using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Linq;
using Rabit.Tool.Geolocation;

namespace Rabit.Tool.Commands;

/// <summary><c>rabit geolocate</c>: where on the ground is this pixel?</summary>
internal static class GeolocateCommand
{
    private const string PixelName = "--pixel";
    private const double MinAltitudeMetres = -1000;
    private const double MaxAltitudeMetres = 100_000;
    private const string PixelIncomplete = PixelName + " needs two numbers: column and row.";

    public static Command Create()
    {
        Argument<string> camera = new("CAMERA")
        {
            Description = "The camera and its mount (docs/camera-folder.md), or a photo (.jpg, .jpeg, .png) that says in its "
                + "EXIF and XMP where it was and how its camera was turned.",
        };
        Argument<string?> request = new("REQUEST") { Description = RequestText, Arity = ArgumentArity.ZeroOrOne };
        Option<string[]> pixel = PixelOption();
        Option<string> telemetry = FileOption(
            "--telemetry", "Poses over time, instead of one: a .tlog of MAVLink, or a table (CSV) with timeSeconds and "
                + "the fields of a pose as columns. Needs --time.");
        Option<double?> time = NumberOption(
            "--time", "SECONDS", "Middle of the exposure (of the top row) by the clock of the telemetry; of a .tlog "
                + "seconds since the autopilot started, or since 1970 by the stamps of the log.");
        Option<string> terrain = FileOption("--terrain", "Heights of the ground, an ARC/INFO ASCII grid in degrees.");
        Option<double?>[] ofPhoto = PhotoOptions();
        var turned = new Option<bool>("--turned")
        {
            Description = "Of a photo: its pixels were turned by half a turn after it was taken.",
        };
        var json = new Option<bool>("--json")
        {
            Description = "JSON out: status \"ok\" with place, covariances and ellipse, or \"refused\" with reason and "
                + "text; a list of several pixels.",
        };
        Option<string> geoJson = FileOption(
            "--geojson", "Also writes a file for maps, GeoJSON: each pixel as a point, with its 95 % ellipse. A file that "
                + "there is, is replaced.");

        var command = new Command(
            "geolocate",
            "Says where on the ground pixels lie: of a camera with a pose or a telemetry log, or of a photo that a "
                + "drone took. Exit code 1 where one has no place.")
        {
            camera, request, pixel, telemetry, time, terrain,
        };
        foreach (Option<double?> option in ofPhoto)
            command.Add(option);
        command.Add(turned);
        command.Add(json);
        command.Add(geoJson);
        CommandLine.CheckFileName(camera, command);
        CommandLine.CheckFileName(request, command);
        command.SetAction(result =>
        {
            var options = new GeolocateOptions
            {
                Camera = result.GetValue(camera)!,
                Request = result.GetValue(request),
                Pixels = [.. (result.GetValue(pixel) ?? []).Select(PixelOf)],
                Telemetry = result.GetValue(telemetry),
                TimeSeconds = result.GetValue(time),
                Terrain = result.GetValue(terrain),
                IsTurned = result.GetValue(turned),
                IsJson = result.GetValue(json),
                GeoJson = result.GetValue(geoJson),
            };
            foreach (Option<double?> option in ofPhoto)
            {
                if (result.GetValue(option) is { } value)
                    options.OfPhoto[option.Name.Substring(2)] = value;
            }

            var console = (ToolConsole)result.InvocationConfiguration;
            return GeolocateRun.Run(options, console.Input, console.Output, console.Error);
        });
        return command;
    }

    /// <summary>Makes one word of the two numbers behind --pixel: U V is U,V.</summary>
    public static IReadOnlyList<string> JoinPixel(IReadOnlyList<string> arguments)
    {
        var joined = new List<string>(arguments.Count);
        foreach (string word in arguments)
        {
            int last = joined.Count - 1;
            if (last > 0 && joined[last - 1] == PixelName && !joined[last].Contains(',')
                && !joined[last].StartsWith("--", StringComparison.Ordinal)
                && !word.StartsWith("--", StringComparison.Ordinal))
                joined[last] += "," + word;
            else
                joined.Add(word);
        }

        return joined;
    }

    private const string RequestText =
        "What is asked, in JSON; - reads it from the standard input. pose: latitudeDegrees, longitudeDegrees, "
        + "altitudeAmslMetres, rollDegrees, pitchDegrees, yawDegrees; optional velocityNorthMetresPerSecond, "
        + "velocityEastMetresPerSecond, velocityDownMetresPerSecond. gimbal: pitchDegrees, yawDegrees; optional, "
        + "straight down. groundAltitudeAmslMetres, not needed with --terrain. pixel: [column, row], or pixels: [[column, "
        + "row], ...], not needed with --pixel.";

    private static Option<string[]> PixelOption()
    {
        var option = new Option<string[]>(PixelName)
        {
            Description = "Column and row, instead of those of the request: U V, or U,V; may be given several times.",
            HelpName = "U V",
            Arity = ArgumentArity.ZeroOrMore,
            AllowMultipleArgumentsPerToken = false,
        };
        option.Validators.Add(result =>
        {
            foreach (string word in result.Tokens.Select(t => t.Value))
            {
                string[] parts = word.Split(',');
                if (parts.Length != 2)
                    result.AddError(PixelIncomplete);
                else if (Array.Find(parts, p => !IsNumber(p, out double n) || !IsFinite(n)) is { } wrong)
                    result.AddError($"{PixelName}: '{wrong}' is not a number.");
            }

            if (result.Tokens.Count < result.IdentifierTokenCount)
                result.AddError(PixelIncomplete);
        });
        return option;
    }

    private static (double Column, double Row) PixelOf(string text)
    {
        double[] parts = text.Split(',').Select(p => IsNumber(p, out double number) ? number : double.NaN).ToArray();
        return (parts[0], parts[1]);
    }

    // They stand in for what a photo does not say, or replace it.
    private static Option<double?>[] PhotoOptions() =>
    [
        NumberOption("--latitude", "DEGREES", "Of a photo: latitude of the camera.", -90, 90),
        NumberOption("--longitude", "DEGREES", "Of a photo: longitude of the camera.", -180, 180),
        NumberOption(
            "--altitude", "METRES", "Of a photo: altitude of the camera above mean sea level.", MinAltitudeMetres,
            MaxAltitudeMetres),
        NumberOption("--height", "METRES", "Of a photo: height of the camera above the ground.", 0, MaxAltitudeMetres),
        NumberOption(
            "--ground-altitude", "METRES", "Of a photo: the ground above mean sea level, instead of --height.",
            MinAltitudeMetres, 10_000),
        NumberOption("--camera-roll", "DEGREES", "Of a photo: roll of the camera against the horizon.", -180, 180),
        NumberOption(
            "--camera-pitch", "DEGREES", "Of a photo: pitch of the camera; -90 is straight down.", -180, 180),
        NumberOption("--camera-yaw", "DEGREES", "Of a photo: yaw of the camera, clockwise from true north.", -360, 360),
        NumberOption("--focal-length", "MILLIMETRES", "Of a photo: with --sensor-width.", 0.1, 10_000),
        NumberOption("--sensor-width", "MILLIMETRES", "Of a photo: the width of the sensor.", 0.1, 1000),
        NumberOption("--focal-length-35mm", "MILLIMETRES", "Of a photo: the equivalent for 35 mm film.", 1, 10_000),
    ];

    private static Option<string> FileOption(string name, string description)
        => new(name) { Description = description, HelpName = "FILE" };

    private static Option<double?> NumberOption(
        string name, string unit, string description, double min = double.MinValue, double max = double.MaxValue)
        => new(name)
        {
            Description = description,
            HelpName = unit,
            CustomParser = result =>
            {
                string text = result.Tokens[0].Value;
                if (!IsNumber(text, out double value))
                    result.AddError($"{name}: '{text}' is not a number.");
                else if (!IsFinite(value))
                    result.AddError($"{name} is {text}, which is not finite.");
                else if (!(value >= min && value <= max))
                    result.AddError(FormattableString.Invariant(
                        $"{name} is {text}; it must be {min} to {max} {unit.ToLowerInvariant()}."));
                return value;
            },
        };

    private static bool IsFinite(double value) => !double.IsNaN(value) && !double.IsInfinity(value);

    private static bool IsNumber(string text, out double value)
        => double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out value);
}
