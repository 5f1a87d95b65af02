using System;
using System.IO;
using System.Text;
using System.Text.Json;

namespace Geolocate;

/// <summary>Where on the ground is this pixel? JSON in, JSON or a text out.</summary>
internal static class Program
{
    private const string Usage = """
        usage: Geolocate camera.json [request.json] [--pixel U V] [--telemetry log.csv --time SECONDS] [--terrain grid.asc] [--json]

        camera.json    camera (as in the README) and mount
        request.json   pose, pixel and ground; - reads it from the standard input
        --pixel        column and row, instead of those of the request
        --telemetry    poses over time, instead of one: time_s,lat_deg,lon_deg,alt_m,vn_mps,ve_mps,vd_mps,roll_deg,pitch_deg,yaw_deg
        --time         middle of the exposure, by the clock of the telemetry
        --terrain      heights of the ground, an ARC/INFO ASCII grid in degrees
        --json         JSON out

        Ends with 0 for a place, 2 for a refusal, 1 for bad input.
        """;

    private static int Main(string[] args)
    {
        try
        {
            if (args.Length == 0 || args[0] is "-h" or "--help")
            {
                Console.WriteLine(Usage);
                return args.Length == 0 ? 1 : 0;
            }

            Console.OutputEncoding = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false);
            CommandLine line = CommandLine.Parse(args);
            return Answer.Write(Request.Read(line).Locate(), line.IsJson, Console.Out);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or JsonException or FormatException or ArgumentException or InvalidOperationException)
        {
            Console.Error.WriteLine(e.Message);
            return 1;
        }
    }
}
