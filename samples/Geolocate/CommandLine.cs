using System;
using System.Globalization;

namespace Geolocate;

/// <summary>What was typed.</summary>
internal sealed class CommandLine
{
    public string Camera { get; private set; } = "";

    public string? Request { get; private set; }

    public string? Telemetry { get; private set; }

    public string? Terrain { get; private set; }

    public double? TimeSeconds { get; private set; }

    public (double Column, double Row)? Pixel { get; private set; }

    public bool IsJson { get; private set; }

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
                    if (i + 2 >= args.Length)
                        throw new FormatException("--pixel needs two numbers: column and row.");
                    line.Pixel = (Number(args, ++i), Number(args, ++i));
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
        return line.Telemetry is null == line.TimeSeconds is null
            ? line
            : throw new FormatException("--telemetry and --time go together.");
    }

    private static string Text(string[] args, int index)
        => index < args.Length ? args[index] : throw new FormatException($"{args[args.Length - 1]} needs a value.");

    private static double Number(string[] args, int index)
        => double.TryParse(Text(args, index), NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
            ? value : throw new FormatException($"'{args[index]}' is not a number.");
}
