using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.SensorFusion;
using Rabit.Uav.SensorFusion.Moving;

namespace Rabit.Uav.Tests.SensorFusion.Moving;

/// <summary>A run of the benchmark RU-MTT-1: scans of every second, and where its five targets were.</summary>
internal sealed class TrackingRun
{
    private TrackingRun(JsonElement line)
    {
        Seed = line.GetProperty("seed").GetInt32();
        Scans = line.GetProperty("scans").EnumerateArray().Select(PointsOf).ToArray();
        Truth = line.GetProperty("truth").EnumerateArray().Select(step => step.EnumerateArray()
            .Select(t => new NedPosition(t[0].GetDouble(), t[2].GetDouble(), 0)).ToArray()).ToArray();
    }

    public int Seed { get; }

    /// <summary>By second.</summary>
    public ScanPoint[][] Scans { get; }

    /// <summary>By second.</summary>
    public NedPosition[][] Truth { get; }

    /// <summary>The scan of a second, without its points.</summary>
    public static Scan ScanOf(int second)
        => new(TimeSpan.FromSeconds(second), 1, 0.9) { AreaSquareMetres = 1e6, ShowsAll = true };

    /// <summary>All runs of a level of clutter: 0, 5 or 20 points a scan.</summary>
    public static List<TrackingRun> All(int clutter)
    {
        var runs = new List<TrackingRun>();
        foreach (string line in Lines(FormattableString.Invariant($"lam{clutter:00}.jsonl.gz")))
        {
            using JsonDocument run = JsonDocument.Parse(line);
            runs.Add(new TrackingRun(run.RootElement));
        }

        return runs;
    }

    /// <summary>The lines of a file of the benchmark.</summary>
    public static IEnumerable<string> Lines(string file)
    {
        using FileStream packed = File.OpenRead(TestData.TrackingPathOf(file));
        using var unpacked = new GZipStream(packed, CompressionMode.Decompress);
        using var reader = new StreamReader(unpacked);
        while (reader.ReadLine() is { } line)
            yield return line;
    }

    private static ScanPoint[] PointsOf(JsonElement scan, int second)
    {
        JsonElement[] r = scan.GetProperty("R").EnumerateArray().ToArray();
        return scan.GetProperty("z").EnumerateArray().Select((z, i) => new ScanPoint(
            new TrackMeasurement(
                new ReportKey(1, second, i),
                TimeSpan.FromSeconds(second),
                z[0].GetDouble(),
                z[1].GetDouble(),
                new HorizontalCovariance(r[i][0].GetDouble(), r[i][1].GetDouble(), r[i][2].GetDouble()),
                default),
            0,
            -1)).ToArray();
    }
}
