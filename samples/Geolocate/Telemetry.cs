using System;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Geolocate;

/// <summary>
/// Poses over time, from a table with commas or from a telemetry log of MAVLink. Only what is around the time is taken: the locator keeps
/// the newest.
/// </summary>
internal static class Telemetry
{
    // What comes later than that after the picture says nothing about it.
    private static readonly TimeSpan Beyond = TimeSpan.FromSeconds(2);

    private static readonly string[] Columns =
        ["time_s", "lat_deg", "lon_deg", "alt_m", "vn_mps", "ve_mps", "vd_mps", "roll_deg", "pitch_deg", "yaw_deg"];

    /// <returns>The time by the clock of the poses.</returns>
    /// <exception cref="FormatException">The file cannot be understood.</exception>
    public static TimeSpan Read(string file, TimeSpan time, PixelGeolocator locator)
    {
        if (Path.GetExtension(file).Equals(".tlog", StringComparison.OrdinalIgnoreCase))
            return TelemetryLog.Read(file, time, Beyond, locator);
        ReadTable(file, time + Beyond, locator);
        return time;
    }

    public static void Add(PixelGeolocator locator, TimeSpan time, double[] p)
    {
        locator.Add(new PoseSample
        {
            Kind = PoseSampleKind.Position,
            Time = time,
            Position = GeodeticPosition.FromDegrees(p[0], p[1], p[2]),
            VelocityNed = new NedVector(p[3], p[4], p[5]),
        });
        locator.Add(new PoseSample { Kind = PoseSampleKind.Attitude, Time = time, Attitude = EulerAngles.FromDegrees(p[6], p[7], p[8]) });
    }

    private static void ReadTable(string file, TimeSpan until, PixelGeolocator locator)
    {
        int number = 0;
        int[] places = [.. Enumerable.Range(0, Columns.Length)];
        int width = Columns.Length;
        foreach (string line in File.ReadLines(file))
        {
            number++;
            string[] words = line.Split(',');
            if (number == 1 && words.Any(w => w.Trim().Length > 0 && char.IsLetter(w.Trim()[0])))
            {
                places = [.. Columns.Select(c => PlaceOf(c, words, file))];
                width = words.Length;
                continue;
            }

            if (words.Length != width)
                throw new FormatException($"Line {number} of {file} has {words.Length} numbers, not {width}.");
            double[] row = [.. places.Select(p => Number(words[p], number, file))];
            TimeSpan time = TimeSpan.FromTicks((long)Math.Round(row[0] * TimeSpan.TicksPerSecond));
            Add(locator, time, [.. row.Skip(1)]);
            if (time > until)
                break;
        }
    }

    private static int PlaceOf(string column, string[] header, string file)
    {
        int place = Array.FindIndex(header, w => w.Trim() == column);
        return place >= 0 ? place : throw new FormatException($"The first line of {file} names no column {column}.");
    }

    private static double Number(string word, int line, string file)
        => double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
            ? value : throw new FormatException($"Line {line} of {file}: '{word}' is not a number.");
}
