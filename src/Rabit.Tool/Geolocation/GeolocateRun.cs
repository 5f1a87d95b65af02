using System;
using System.IO;
using Rabit.Vision;

namespace Rabit.Tool.Geolocation;

/// <summary>The main job: reads what is asked and writes the place, or why there is none.</summary>
internal static class GeolocateRun
{
    /// <returns>The exit code.</returns>
    /// <exception cref="ToolException">Something is missing, unknown or cannot be read.</exception>
    public static int Run(GeolocateOptions options, TextReader input, TextWriter output)
    {
        if (options.FindFault() is { } fault)
            throw new ToolException(fault);
        string?[] files = [options.Camera, options.Request, options.Telemetry, options.Terrain];
        if (Array.Find(files, Directory.Exists) is { } folder)
            throw new ToolException($"{folder}: that is a folder.");
        return Answer.Write(Read(options, input).Locate(), options.IsJson, output);
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
