using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Json;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Reads where the pictures come from, if not from the folder of camera.json: its source.</summary>
internal static class CameraSourceDescription
{
    private const string Program = "program";
    private const string Arguments = "arguments";
    private const string Format = "format";
    private const string Rate = "framesPerSecond";
    private const string Exposure = "exposureMicroseconds";
    private const string Latency = "latencyMicroseconds";
    private const string TimeNoise = "timeNoiseMicroseconds";
    private const string Stall = "stallTimeoutSeconds";
    private const double MaxMicroseconds = 10e6;

    /// <param name="source">The object of the source.</param>
    /// <param name="model">The camera, whose size the pictures have.</param>
    /// <param name="folder">What the path of a program is relative to.</param>
    /// <param name="faults">Those that <paramref name="source"/> adds to; where there are any, the result is of no
    /// use.</param>
    public static ProcessCameraOptions Read(
        JsonFields source, CameraModel model, string folder, List<string> faults)
    {
        string? program = source.Text(Program);
        if (program is null)
            source.Missing(Program);
        else if (string.IsNullOrWhiteSpace(program))
            faults.Add($"source.{Program} is empty");
        double? rate = ReadRate(source, faults);
        var defaults = new ProcessCameraOptions();
        var options = new ProcessCameraOptions
        {
            Program = PathOf(program ?? string.Empty, folder),
            Arguments = ReadArguments(source, model, rate, faults),
            Format = source.Choice(Format, "mjpeg", "yuv420", "yuv420FullRange") switch
            {
                "yuv420" => ProcessCameraFormat.Yuv420,
                "yuv420FullRange" => ProcessCameraFormat.Yuv420FullRange,
                _ => ProcessCameraFormat.Mjpeg,
            },
            Width = model.Width,
            Height = model.Height,
            MaxFramesPerSecond = rate,
            Exposure = ReadMicroseconds(source, Exposure, defaults.Exposure, faults),
            Latency = ReadMicroseconds(source, Latency, defaults.Latency, faults),
            TimeNoise = ReadMicroseconds(source, TimeNoise, defaults.TimeNoise, faults),
            StallTimeout = ReadStall(source, defaults.StallTimeout, faults),
        };
        source.RefuseOthers();
        return options;
    }

    // With a folder in it, it is a file beside camera.json, as the pictures that are listed there are; else PATH is
    // searched.
    private static string PathOf(string program, string folder)
        => program.IndexOfAny(['/', '\\']) >= 0 && program.IndexOfAny(Path.GetInvalidPathChars()) < 0
            ? Path.Combine(folder, program)
            : program;

    private static double? ReadRate(JsonFields source, List<string> faults)
    {
        if (source.Number(Rate) is not { } rate)
            return null;
        if (rate is >= ProcessCameraOptions.MinRate and <= ProcessCameraOptions.MaxRate)
            return rate;
        if (!double.IsNaN(rate))
            faults.Add(FormattableString.Invariant(
                $"source.{Rate} is {rate}; it must be {ProcessCameraOptions.MinRate} to {ProcessCameraOptions.MaxRate}"));
        return null;
    }

    private static string[] ReadArguments(
        JsonFields source, CameraModel model, double? rate, List<string> faults)
    {
        if (source.Array(Arguments) is not { } list)
            return [];
        if (list.EnumerateArray().Any(a => a.ValueKind != JsonValueKind.String))
        {
            source.Blame(Arguments, list, "must be a list of texts, one for each argument");
            return [];
        }

        string[] arguments = [.. list.EnumerateArray().Select(a => a.GetString()!)];
        if (rate is null && Array.Exists(arguments, a => a.Contains("{" + Rate + "}")))
            faults.Add($"source.{Rate} is missing, and {{{Rate}}} stands in source.{Arguments}");
        return Array.ConvertAll(arguments, a => a
            .Replace("{width}", model.Width.ToString(CultureInfo.InvariantCulture))
            .Replace("{height}", model.Height.ToString(CultureInfo.InvariantCulture))
            .Replace("{" + Rate + "}", (rate ?? 0).ToString(CultureInfo.InvariantCulture)));
    }

    private static TimeSpan ReadMicroseconds(
        JsonFields source, string name, TimeSpan otherwise, List<string> faults)
    {
        if (source.Number(name) is not { } microseconds)
            return otherwise;
        if (microseconds is >= 0 and <= MaxMicroseconds)
            return TimeSpan.FromTicks((long)(microseconds * PictureFolderWriter.TicksPerMicrosecond));
        if (!double.IsNaN(microseconds))
            faults.Add(FormattableString.Invariant(
                $"source.{name} is {microseconds}; it must be 0 to {MaxMicroseconds}"));
        return otherwise;
    }

    private static TimeSpan ReadStall(JsonFields source, TimeSpan otherwise, List<string> faults)
    {
        if (source.Number(Stall) is not { } seconds)
            return otherwise;
        if (seconds is >= 0.1 and <= 600)
            return TimeSpan.FromSeconds(seconds);
        if (!double.IsNaN(seconds))
            faults.Add(FormattableString.Invariant($"source.{Stall} is {seconds}; it must be 0.1 to 600"));
        return otherwise;
    }
}
