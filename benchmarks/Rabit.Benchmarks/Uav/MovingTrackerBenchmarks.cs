using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text.Json;
using BenchmarkDotNet.Attributes;
using Rabit.Geodesy;
using Rabit.Uav.SensorFusion;
using Rabit.Uav.SensorFusion.Moving;

namespace Rabit.Benchmarks.Uav;

/// <summary>
/// A scan of RU-MTT-1: the mean over the 100 scans of its first run, with five targets and so many points of clutter.
/// </summary>
[MemoryDiagnoser]
public class MovingTrackerBenchmarks
{
    private const int Scans = 100;

    private readonly List<ScanPoint[]> _scans = [];
    private MovingTracker _tracker = null!;

    [Params(0, 5, 20)]
    public int Clutter { get; set; }

    [GlobalSetup]
    public void Read()
    {
        string file = Path.Combine(AppContext.BaseDirectory, "data", $"lam{Clutter:00}.jsonl.gz");
        using var reader = new StreamReader(new GZipStream(File.OpenRead(file), CompressionMode.Decompress));
        using JsonDocument run = JsonDocument.Parse(reader.ReadLine()!);
        foreach (JsonElement scan in run.RootElement.GetProperty("scans").EnumerateArray())
            _scans.Add(scan.GetProperty("z").EnumerateArray().Select(PointOf).ToArray());
        int id = 0;
        _tracker = new MovingTracker(new TrackerSettings(), [MotionModel.ConstantVelocity(0.1, 3)], () => ++id);
    }

    [Benchmark(OperationsPerInvoke = Scans)]
    public int Update()
    {
        _tracker.Clear();
        for (int i = 0; i < Scans; i++)
        {
            var scan = new Scan(TimeSpan.FromSeconds(i), 1, 0.9) { AreaSquareMetres = 1e6, ShowsAll = true };
            _tracker.Update(scan, _scans[i]);
        }

        return _tracker.Tracks.Count;
    }

    private ScanPoint PointOf(JsonElement place, int index) => new(
        new TrackMeasurement(
            new ReportKey(1, _scans.Count, index),
            TimeSpan.FromSeconds(_scans.Count),
            place[0].GetDouble(),
            place[1].GetDouble(),
            new HorizontalCovariance(25, 0, 25),
            default),
        0,
        -1);
}
