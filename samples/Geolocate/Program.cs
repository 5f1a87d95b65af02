using System;
using System.IO;
using System.Text;
using System.Text.Json;

namespace Geolocate;

/// <summary>Where on the ground is this pixel? JSON in, JSON or a text out.</summary>
internal static class Program
{
    private const string Usage = """
        usage: Geolocate camera.json [request.json] [--pixel U V] [--telemetry log.csv|log.tlog --time SECONDS] [--terrain grid.asc] [--json]

        camera.json    width, height, fx, fy, cx, cy, dist_k1_k2_p1_p2_k3, row_readout_us, and the mount (see the sample's own camera.json)
        request.json   pose, pixel and ground; - reads it from the standard input
        --pixel        column and row, instead of those of the request
        --telemetry    poses over time, instead of one: a .tlog of MAVLink, or a table with the columns
                       time_s,lat_deg,lon_deg,alt_m,vn_mps,ve_mps,vd_mps,roll_deg,pitch_deg,yaw_deg
        --time         middle of the exposure (of the top row) by the clock of the telemetry; of a .tlog seconds since the autopilot
                       started, or since 1970 by the stamps of the log
        --terrain      heights of the ground, an ARC/INFO ASCII grid in degrees
        --json         JSON out

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
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or JsonException or FormatException or ArgumentException or InvalidOperationException)
        {
            errors.WriteLine(e.Message);
            return 1;
        }
    }

    private static int Main(string[] args)
    {
        Console.OutputEncoding = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false);
        return Run(args, Console.In, Console.Out, Console.Error);
    }
}
