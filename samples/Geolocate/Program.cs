using System;
using System.IO;
using System.Text;
using Rabit.Vision;

namespace Geolocate;

/// <summary>Where on the ground is this pixel? JSON in, JSON or a text out.</summary>
internal static class Program
{
    private const string Usage = """
        usage: Geolocate camera.json [request.json] [--pixel U V] [--telemetry log.csv|log.tlog --time SECONDS] [--terrain grid.asc] [--json]
               Geolocate photo.jpg --pixel U,V [--terrain grid.asc] [--json] [what the photo does not say]

        camera.json    the camera and its mount, as docs/camera-folder.md describes them
        request.json   what is asked; - reads it from the standard input:
                         pose      latitudeDegrees, longitudeDegrees, altitudeAmslMetres, rollDegrees, pitchDegrees, yawDegrees; optional
                                   velocityNorthMetresPerSecond, velocityEastMetresPerSecond, velocityDownMetresPerSecond
                         gimbal    pitchDegrees, yawDegrees; optional: straight down. Of no effect for a fixed camera
                         groundAltitudeAmslMetres   not needed with --terrain
                         pixel     [column, row]; not needed with --pixel
        --pixel        column and row, instead of those of the request
        --telemetry    poses over time, instead of one: a .tlog of MAVLink, or a table (CSV) with timeSeconds and the fields of a pose as columns
        --time         middle of the exposure (of the top row) by the clock of the telemetry; of a .tlog seconds since the autopilot
                       started, or since 1970 by the stamps of the log
        --terrain      heights of the ground, an ARC/INFO ASCII grid in degrees
        photo.jpg      a photo of a drone, whose EXIF and XMP say where it was and how its camera was turned. What they do not say, or say wrong:
                         --latitude, --longitude   of the camera, degrees
                         --altitude                of the camera above mean sea level, metres
                         --height                  of the camera above the ground, metres; or --ground-altitude above mean sea level
                         --camera-roll, --camera-pitch, --camera-yaw   of the camera against horizon and north, degrees; pitch -90 is straight down
                         --focal-length, --sensor-width   millimetres; or --focal-length-35mm
                         --turned                  the pixels were turned by half a turn after the photo was taken
        --json         JSON out: status "ok" with place, covariances and ellipse, or "refused" with reason and text

        Ends with 0 for a place, 2 for a refusal, 1 for bad input.
        """;

    /// <summary>All of it.</summary>
    /// <returns>The exit code.</returns>
    internal static int Run(string[] args, TextReader input, TextWriter output, TextWriter errors)
    {
        try
        {
            if (args.Length == 0 || args[0] is "-h" or "--help")
            {
                output.WriteLine(Usage);
                return args.Length == 0 ? 1 : 0;
            }

            CommandLine line = CommandLine.Parse(args);
            return Answer.Write(Request.Read(line, input).Locate(), line.IsJson, output);
        }
        catch (Exception e)
            when (e is IOException or UnauthorizedAccessException or FormatException or PictureException
                or ArgumentException)
        {
            // An ArgumentException has the name of its parameter on a line of its own on some runtimes.
            errors.WriteLine(e.Message.Replace("\r", "").Replace('\n', ' '));
            return 1;
        }
    }

    private static int Main(string[] args)
    {
        Console.OutputEncoding = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false);
        return Run(args, Console.In, Console.Out, Console.Error);
    }
}
