using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;

namespace Geolocate;

/// <summary>What was typed.</summary>
internal sealed class CommandLine
{
    /// <summary>Options with a number that stand in for what a photo does not say, or replace it.</summary>
    private static readonly string[] PhotoOptions =
    [
        "latitude", "longitude", "altitude", "height", "ground-altitude", "camera-roll", "camera-pitch", "camera-yaw",
        "focal-length", "sensor-width", "focal-length-35mm",
    ];

    private readonly Dictionary<string, double> _ofPhoto = new(StringComparer.Ordinal);

    public string Camera { get; private set; } = "";

    public string? Request { get; private set; }

    public string? Telemetry { get; private set; }

    public string? Terrain { get; private set; }

    public double? TimeSeconds { get; private set; }

    public (double Column, double Row)? Pixel { get; private set; }

    public bool IsJson { get; private set; }

    /// <summary>Whether the first file is a photo, which describes its camera itself.</summary>
    public bool IsPhoto => Path.GetExtension(Camera).ToUpperInvariant() is ".JPG" or ".JPEG";

    /// <summary>Whether the pixels of the photo were turned by half a turn after it was taken.</summary>
    public bool IsTurned { get; private set; }

    /// <summary>What the options say of a photo, by their names without dashes.</summary>
    public IReadOnlyDictionary<string, double> OfPhoto => _ofPhoto;

    /// <exception cref="FormatException">It cannot be understood.</exception>
    public static CommandLine Parse(string[] args)
    {
        var line = new CommandLine();
        for (int i = 0; i < args.Length; i++)
        {
            switch (args[i])
            {
                case "--json":
                    line.IsJson = true;
                    break;
                case "--pixel":
                    line.Pixel = PixelOf(args, ref i);
                    break;
                case "--turned":
                    line.IsTurned = true;
                    break;
                case var word when word.StartsWith("--", StringComparison.Ordinal)
                    && PhotoOptions.Contains(word.Substring(2)):
                    line._ofPhoto[word.Substring(2)] = Finite(args, ++i);
                    break;
                case "--telemetry":
                    line.Telemetry = Text(args, ++i);
                    break;
                case "--terrain":
                    line.Terrain = Text(args, ++i);
                    break;
                case "--time":
                    line.TimeSeconds = Number(args, ++i);
                    break;
                case var word when word.StartsWith("--", StringComparison.Ordinal):
                    throw new FormatException($"There is no option {word}.");
                case var file when line.Camera.Length == 0:
                    line.Camera = file;
                    break;
                case var file when line.Request is null:
                    line.Request = file;
                    break;
                default:
                    throw new FormatException($"There is one word too many: {args[i]}.");
            }
        }

        if (line.Camera.Length == 0)
            throw new FormatException("The camera's file is missing.");
        if (line.Telemetry is null != line.TimeSeconds is null)
            throw new FormatException("--telemetry and --time go together.");
        line.DemandSense();
        return line;
    }

    private void DemandSense()
    {
        if (!IsPhoto && (IsTurned || _ofPhoto.Count > 0))
            throw new FormatException(
                $"--{(IsTurned ? "turned" : _ofPhoto.Keys.First())} is for a photo (.jpg, .jpeg), which {Camera} is not.");
        if (IsPhoto && (Request ?? Telemetry) is { } other)
            throw new FormatException($"{Camera} is a photo, which needs no {other}.");
    }

    private static (double Column, double Row) PixelOf(string[] args, ref int i)
    {
        if (i + 1 < args.Length && args[i + 1].IndexOf(',') is > 0 and int comma)
        {
            string both = args[++i];
            string[] parts = [both.Substring(0, comma), both.Substring(comma + 1)];
            return (Number(parts, 0), Number(parts, 1));
        }

        if (i + 2 >= args.Length)
            throw new FormatException("--pixel needs two numbers: column and row.");
        return (Number(args, ++i), Number(args, ++i));
    }

    private static string Text(string[] args, int index)
        => index < args.Length ? args[index] : throw new FormatException($"{args[args.Length - 1]} needs a value.");

    private static double Finite(string[] args, int index)
        => Number(args, index) is var value && !double.IsNaN(value) && !double.IsInfinity(value)
            ? value : throw new FormatException($"{args[index - 1]} is {args[index]}, which is not finite.");

    private static double Number(string[] args, int index)
        => double.TryParse(Text(args, index), NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
            ? value : throw new FormatException($"'{args[index]}' is not a number.");
}
