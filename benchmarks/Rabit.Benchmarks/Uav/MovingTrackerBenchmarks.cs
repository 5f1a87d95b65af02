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
/// A scan of RU-MTT-1: the mean over the 100 scans of each of its 20 runs, with five targets and so many points of
/// clutter.
/// </summary>
[MemoryDiagnoser]
public class MovingTrackerBenchmarks
{
    private const int Scans = 100;
    private const int Runs = 20;

    private readonly List<ScanPoint[]> _scans = [];
    private MovingTracker _tracker = null!;

    [Params(0, 5, 20)]
    public int Clutter { get; set; }

    [GlobalSetup]
    public void Read()
    {
        string file = Path.Combine(AppContext.BaseDirectory, "data", $"lam{Clutter:00}.jsonl.gz");
        using var reader = new StreamReader(new GZipStream(File.OpenRead(file), CompressionMode.Decompress));
        while (reader.ReadLine() is { } line)
        {
            using JsonDocument run = JsonDocument.Parse(line);
            foreach (JsonElement scan in run.RootElement.GetProperty("scans").EnumerateArray())
                _scans.Add(scan.GetProperty("z").EnumerateArray().Select(PointOf).ToArray());
        }

        if (_scans.Count != Runs * Scans)
            throw new InvalidDataException($"{file} has {_scans.Count} scans.");
        int id = 0;
        _tracker = new MovingTracker(new TrackerSettings(), [MotionModel.ConstantVelocity(0.1, 3)], () => ++id);
    }

    [Benchmark(OperationsPerInvoke = Runs * Scans)]
    public int Update()
    {
        for (int i = 0; i < _scans.Count; i++)
        {
            if (i % Scans == 0)
                _tracker.Clear();
            var scan = new Scan(TimeOf(i), 1, 0.9) { AreaSquareMetres = 1e6, ShowsAll = true };
            _tracker.Update(scan, _scans[i]);
        }

        return _tracker.Tracks.Count;
    }

    private static TimeSpan TimeOf(int scan) => TimeSpan.FromSeconds(scan % Scans);

    private ScanPoint PointOf(JsonElement place, int index) => new(
        new TrackMeasurement(
            new ReportKey(1, _scans.Count, index),
            TimeOf(_scans.Count),
            place[0].GetDouble(),
            place[1].GetDouble(),
            new HorizontalCovariance(25, 0, 25),
            default),
        0,
        -1);
}
