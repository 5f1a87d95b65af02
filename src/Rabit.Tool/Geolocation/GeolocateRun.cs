using System;
using System.Collections.Generic;
using System.IO;
using Rabit.Files;
using Rabit.Vision;

namespace Rabit.Tool.Geolocation;

/// <summary>The main job: reads what is asked and writes the places, or why there is none.</summary>
internal static class GeolocateRun
{
    /// <returns>The exit code.</returns>
    /// <exception cref="ToolException">Something is missing, unknown or cannot be read.</exception>
    public static int Run(GeolocateOptions options, TextReader input, TextWriter output, TextWriter errors)
    {
        if (options.FindFault() is { } fault)
            throw new ToolException(fault);
        string?[] files = [options.Camera, options.Request, options.Telemetry, options.Terrain, options.GeoJson];
        if (Array.Find(files, Directory.Exists) is { } folder)
            throw new ToolException($"{folder}: that is a folder.");
        foreach (string? read in files)
            CheckIsFile(read, options);
        Request request = Read(options, input);
        if (request.Warning is { } warning)
            Warn(warning, errors);
        IReadOnlyList<LocatedPixel> pixels = request.Locate();
        if (options.GeoJson is { } file)
            WriteGeoJson(file, pixels);
        return Answer.Write(pixels, request.IsList, options.IsJson, output);
    }

    // Who opens a pipe waits for its writer, and a device may have no end. What is only written may be a device.
    private static void CheckIsFile(string? file, GeolocateOptions options)
    {
        if (file is not { Length: > 0 } || SpecialFile.FindKind(file) is not { } kind
            || (file == options.GeoJson && kind == "a device"))
            return;
        string hint = file == options.Request ? "; - reads the standard input." : ".";
        throw new ToolException($"{file}: it is {kind}, not a file{hint}");
    }

    private static void Warn(string warning, TextWriter errors)
    {
        try
        {
            errors.WriteLine($"rabit geolocate: {CommandLine.OneLine(warning)}");
        }
        catch (IOException)
        {
            // Standard error is closed; the answer is not.
        }
    }

    private static void WriteGeoJson(string file, IReadOnlyList<LocatedPixel> pixels)
    {
        try
        {
            using FileStream output = File.Create(file);
            GeoJsonAnswer.Write(output, pixels);
        }
        catch (Exception e)
            when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new ToolException($"--geojson {file}: it cannot be written: {e.Message}", e);
        }
    }

    private static Request Read(GeolocateOptions options, TextReader input)
    {
        try
        {
            return Request.Read(options, input);
        }
        catch (Exception e)
            when (e is IOException or UnauthorizedAccessException or FormatException or PictureException
                or ArgumentException)
        {
            throw new ToolException(e.Message, e);
        }
    }
}
