using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Rabit.Tool.Geolocation;

/// <summary>
/// Poses over time, from a table with commas or from a telemetry log of MAVLink. Only what is around the time is taken:
/// the locator keeps the newest.
/// </summary>
internal static class Telemetry
{
    // Poses later than that after the picture are not needed for it.
    private static readonly TimeSpan Beyond = TimeSpan.FromSeconds(2);

    private static readonly string[] Columns = ["timeSeconds", .. PoseField.All.Select(f => f.Name)];

    /// <param name="file">A table or a log.</param>
    /// <param name="time">Of the picture.</param>
    /// <param name="locator">Takes the poses.</param>
    /// <param name="usesGimbal">Whether a log's reports of a gimbal are taken too.</param>
    /// <returns>The time by the clock of the poses.</returns>
    /// <exception cref="FormatException">The file cannot be understood.</exception>
    public static TimeSpan Read(string file, TimeSpan time, PixelGeolocator locator, bool usesGimbal)
    {
        if (Path.GetExtension(file).Equals(".tlog", StringComparison.OrdinalIgnoreCase))
            return TelemetryLog.Read(file, time, Beyond, locator, usesGimbal);
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
        locator.Add(
            new PoseSample
            {
                Kind = PoseSampleKind.Attitude,
                Time = time,
                Attitude = EulerAngles.FromDegrees(p[6], p[7], p[8])
            });
    }

    private static void ReadTable(string file, TimeSpan until, PixelGeolocator locator)
    {
        (int number, int poses) = (0, 0);
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
            if (!(Math.Abs(row[0]) <= Request.MaxSeconds))
                throw new FormatException(FormattableString.Invariant(
                    $"Line {number} of {file}: {Columns[0]} is {row[0]}; it must be seconds, {Request.MaxSeconds} at most."));
            TimeSpan time = TimeSpan.FromTicks((long)Math.Round(row[0] * TimeSpan.TicksPerSecond));
            Check(row, number, file);
            Add(locator, time, [.. row.Skip(1)]);
            poses++;
            if (time > until)
                break;
        }

        if (poses == 0)
            throw new FormatException($"{file} has no poses.");
    }

    private static int PlaceOf(string column, string[] header, string file)
    {
        int place = Array.FindIndex(header, w => w.Trim() == column);
        if (place >= 0)
            return place;
        throw new FormatException(
            header.Select(w => w.Trim()).FirstOrDefault(w => OldNames.NewNameOf(w) == column) is { } old
                ? $"The first line of {file} names a column {old}, of an older form of the file; it is {column} now."
                : $"The first line of {file} names no column {column}.");
    }

    private static void Check(double[] row, int line, string file)
    {
        for (int i = 0; i < PoseField.All.Count; i++)
        {
            PoseField field = PoseField.All[i];
            if (!field.Holds(row[i + 1]))
                throw new FormatException(FormattableString.Invariant(
                    $"Line {line} of {file}: {field.Name} is {row[i + 1]}; it must be {field.Range}."));
        }
    }

    private static double Number(string word, int line, string file)
        => double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
            ? value : throw new FormatException($"Line {line} of {file}: '{word}' is not a number.");
}
