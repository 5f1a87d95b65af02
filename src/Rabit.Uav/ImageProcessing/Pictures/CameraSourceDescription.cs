using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Json;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Reads where the pictures come from, if not from the folder of camera.json: its source.</summary>
internal static class CameraSourceDescription
{
    private const string Program = "program";
    private const string Arguments = "arguments";
    private const string Device = "device";
    private const string Focus = "focus";
    private const string Format = "format";
    private const string RowBytes = "rowBytes";
    private const string Rate = "framesPerSecond";
    private const string Exposure = "exposureMicroseconds";
    private const string Latency = "latencyMicroseconds";
    private const string TimeNoise = "timeNoiseMicroseconds";
    private const string MetadataTimeNoise = "metadataTimeNoiseMicroseconds";
    private const string Stall = "stallTimeoutSeconds";
    private const double MinExposure = 100;
    private const double MaxMicroseconds = 10e6;

    // Of a program without metadata, or for the pictures whose metadata do not come.
    private static readonly double MinArrivalNoise
        = PictureTimeSource.MinArrivalNoise.Ticks / PictureFolderWriter.TicksPerMicrosecond;

    /// <param name="source">The object of the source.</param>
    /// <param name="model">The camera, whose size the pictures have.</param>
    /// <param name="folder">What the path of a program is relative to.</param>
    /// <param name="faults">
    /// Those that <paramref name="source"/> adds to; where there are any, what is returned is of no use.
    /// </param>
    public static CameraSource Read(JsonFields source, CameraModel model, string folder, List<string> faults)
    {
        bool isDevice = source.Has(Device);
        if (isDevice && source.Has(Program))
            faults.Add($"source has both a {Program} and a {Device}; it must have one of them");
        CameraSource read = isDevice
            ? new CameraSource { Device = ReadDevice(source, model, faults) }
            : new CameraSource { Program = ReadProgram(source, model, folder, faults) };
        source.RefuseOthers();
        return read;
    }

    private static ProcessCameraOptions ReadProgram(
        JsonFields source, CameraModel model, string folder, List<string> faults)
    {
        string? program = source.Text(Program);
        if (program is null)
            source.Missing(Program);
        else if (string.IsNullOrWhiteSpace(program))
            faults.Add($"source.{Program} is empty");
        double? rate = ReadRate(source, faults);
        string[] arguments = ReadArguments(source, model, rate, faults);
        CheckMetadata(source, arguments, faults);
        var defaults = new ProcessCameraOptions();
        ProcessCameraFormat format = ReadFormat(source, model, faults);
        return new ProcessCameraOptions
        {
            Program = PathOf(program ?? string.Empty, folder),
            Arguments = arguments,
            Format = format,
            Width = model.Width,
            Height = model.Height,
            RowBytes = ReadRowBytes(source, format, model.Width, faults),
            MaxFramesPerSecond = rate,
            Exposure = ReadMicroseconds(source, Exposure, 0, faults) ?? defaults.Exposure,
            Latency = ReadMicroseconds(source, Latency, 0, faults) ?? defaults.Latency,
            TimeNoise = ReadMicroseconds(source, TimeNoise, MinArrivalNoise, faults) ?? defaults.TimeNoise,
            MetadataTimeNoise = ReadMicroseconds(source, MetadataTimeNoise, 0, faults) ?? defaults.MetadataTimeNoise,
            StallTimeout = ReadStall(source, defaults.StallTimeout, faults),
        };
    }

    // A thermal camera writes counts, and no other camera does.
    private static ProcessCameraFormat ReadFormat(JsonFields source, CameraModel model, List<string> faults)
    {
        bool isThermal = model.Format == PixelFormat.Grey16;
        ProcessCameraFormat? format = source.Choice(Format, "mjpeg", "yuv420", "yuv420FullRange", "grey16") switch
        {
            "mjpeg" => ProcessCameraFormat.Mjpeg,
            "yuv420" => ProcessCameraFormat.Yuv420,
            "yuv420FullRange" => ProcessCameraFormat.Yuv420FullRange,
            "grey16" => ProcessCameraFormat.Grey16,
            _ => null,
        };
        if (format is { } given && isThermal != (given == ProcessCameraFormat.Grey16))
        {
            faults.Add($"source.{Format} and camera.pixels do not match: a thermal camera, whose pixels are grey16, "
                + "writes the format grey16, and no other camera does");
        }

        return format ?? (isThermal ? ProcessCameraFormat.Grey16 : ProcessCameraFormat.Mjpeg);
    }

    private static int? ReadRowBytes(JsonFields source, ProcessCameraFormat format, int width, List<string> faults)
    {
        if (!source.Has(RowBytes))
            return null;
        int bytes = source.RequiredWholeNumber(RowBytes);
        if (ProcessCameraOptions.FindRowFault(bytes, format, width) is { } fault)
            faults.Add($"source.{RowBytes}: {fault}");
        return bytes;
    }

    private static V4l2CameraOptions ReadDevice(JsonFields source, CameraModel model, List<string> faults)
    {
        string? device = source.Text(Device);
        if (device is not null && string.IsNullOrWhiteSpace(device))
            faults.Add($"source.{Device} is empty");
        if (model.Format != PixelFormat.Rgb24)
            faults.Add($"source.{Device}: video devices are read as cameras of colour, and camera.pixels says grey16");
        if (!OperatingSystem.IsLinux())
            faults.Add($"source.{Device}: video devices are read on Linux only");
        bool isRaw = source.Choice(Format, "mjpeg", "yuyv") == "yuyv";
        if (isRaw && model.Width % 2 != 0)
            faults.Add(FormattableString.Invariant($"camera.width is {model.Width}; it must be even for yuyv"));
        return new V4l2CameraOptions
        {
            Device = device ?? string.Empty,
            Format = isRaw ? V4l2PixelFormat.Yuyv : V4l2PixelFormat.Mjpeg,
            Width = model.Width,
            Height = model.Height,
            FramesPerSecond = ReadRate(source, faults),
            Exposure = ReadMicroseconds(source, Exposure, MinExposure, faults),
            Focus = source.Has(Focus) ? source.RequiredWholeNumber(Focus) : null,
            Readout = model.Readout,
            Latency = ReadMicroseconds(source, Latency, 0, faults),
            TimeNoise = ReadMicroseconds(source, TimeNoise, 0, faults),
            StallTimeout = ReadStall(source, new V4l2CameraOptions().StallTimeout, faults),
        };
    }

    // With a folder in it, it is a file beside camera.json, as the pictures that are listed there are; else PATH is
    // searched.
    private static string PathOf(string program, string folder)
        => program.IndexOfAny(['/', '\\']) >= 0 && program.IndexOfAny(Path.GetInvalidPathChars()) < 0
            ? Path.Combine(folder, program)
            : program;

    private static double? ReadRate(JsonFields source, List<string> faults)
        => ReadNumber(source, Rate, ProcessCameraOptions.MinRate, ProcessCameraOptions.MaxRate, faults);

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
        if (!source.Has(Rate) && Array.Exists(arguments, a => a.Contains("{" + Rate + "}")))
            faults.Add($"source.{Rate} is missing, and {{{Rate}}} stands in source.{Arguments}");
        return Array.ConvertAll(arguments, a => a
            .Replace("{width}", model.Width.ToString(CultureInfo.InvariantCulture))
            .Replace("{height}", model.Height.ToString(CultureInfo.InvariantCulture))
            .Replace("{" + Rate + "}", (rate ?? 0).ToString(CultureInfo.InvariantCulture)));
    }

    private static void CheckMetadata(JsonFields source, string[] arguments, List<string> faults)
    {
        const string place = ProcessCameraOptions.MetadataPlace;
        bool hasMetadata = Array.Exists(arguments, a => a.Contains(place));
        if (hasMetadata && !OperatingSystem.IsLinux())
            faults.Add($"{place} stands in source.{Arguments}, and works on Linux only");
        if (!hasMetadata && source.Has(MetadataTimeNoise))
            faults.Add($"source.{MetadataTimeNoise} is of use only where {place} stands in source.{Arguments}");
    }

    private static TimeSpan? ReadMicroseconds(JsonFields source, string name, double min, List<string> faults)
        => ReadNumber(source, name, min, MaxMicroseconds, faults) is { } microseconds
            ? TimeSpan.FromTicks((long)(microseconds * PictureFolderWriter.TicksPerMicrosecond))
            : default(TimeSpan?);

    private static TimeSpan ReadStall(JsonFields source, TimeSpan otherwise, List<string> faults)
        => ReadNumber(source, Stall, 0.1, 600, faults) is { } seconds ? TimeSpan.OfSeconds(seconds) : otherwise;

    private static double? ReadNumber(JsonFields source, string name, double min, double max, List<string> faults)
    {
        if (source.Number(name) is not { } number)
            return null;
        if (number >= min && number <= max)
            return number;
        if (!double.IsNaN(number))
            faults.Add(FormattableString.Invariant($"source.{name} is {number}; it must be {min} to {max}"));
        return null;
    }
}
