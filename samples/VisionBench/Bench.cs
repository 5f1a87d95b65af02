using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Diagnostics;
using System.IO;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace VisionBench;

/// <summary>Runs a detector over a set.</summary>
internal sealed class Bench(
    ITargetDetector detector, ImmutableArray<TargetClass> classes, bool isColourEnough, int repeats)
{
    private readonly PictureReader _reader = new();
    private readonly MarkerBench _markers = new(repeats);
    private readonly TargetDetection[] _found = new TargetDetection[64];
    private byte[] _pixels = [];

    /// <summary>Time in the detector so far.</summary>
    public TimeSpan DetectorTime { get; private set; }

    /// <summary>Time in the detector of markers so far.</summary>
    public TimeSpan MarkerTime => _markers.Time;

    public IEnumerable<FrameScore> Run(PictureSet set, Action<int, int> onProgress)
    {
        foreach (ListedFrame frame in set.Frames)
        {
            yield return Run(frame);
            onProgress(frame.Index, set.Frames.Length);
        }
    }

    private FrameScore Run(ListedFrame frame)
    {
        (int width, int height) = (frame.Camera.Width, frame.Camera.Height);
        if (_pixels.Length < width * height * 3)
            _pixels = new byte[width * height * 3];
        _reader.LoadInto(frame.FilePath, width, height, _pixels);
        var input = new DetectorInput(_pixels, width, height, classes, frame.CreateScale());
        DetectorResult result = Detect(input);
        if (result.Refusal is not null)
            throw new IOException($"{frame.Name}: {result.Refusal}");
        var score = new FrameScore(frame, _found.AsSpan(0, result.Count), isColourEnough);
        foreach (TargetMatch match in score.Matches)
            match.IsClipped = IsClipped(match.Target, width, height);
        score.Markers = _markers.Search(frame.Markers, _pixels, width, height);
        return score;
    }

    // The shortest of the repeats counts: what else the machine does has no part in it.
    private DetectorResult Detect(in DetectorInput input)
    {
        long shortest = long.MaxValue;
        DetectorResult result = default;
        for (int i = 0; i < repeats; i++)
        {
            long start = Stopwatch.GetTimestamp();
            result = detector.Detect(input, _found);
            shortest = Math.Min(shortest, Stopwatch.GetTimestamp() - start);
        }

        DetectorTime += TimeSpan.FromTicks(
            (long)(shortest * (double)TimeSpan.TicksPerSecond / Stopwatch.Frequency));
        return result;
    }

    // Half of the pixels about its middle have a channel at its end.
    private bool IsClipped(ListedTarget target, int width, int height)
    {
        int reach = (int)Math.Max(1, target.Size / 4);
        (int clipped, int all) = (0, 0);
        for (int row = (int)Math.Round(target.Y) - reach; row <= (int)Math.Round(target.Y) + reach; row++)
        {
            for (int column = (int)Math.Round(target.X) - reach; column <= (int)Math.Round(target.X) + reach; column++)
            {
                if (column < 0 || row < 0 || column >= width || row >= height)
                    continue;
                int at = ((row * width) + column) * 3;
                all++;
                if (_pixels[at] >= 250 || _pixels[at + 1] >= 250 || _pixels[at + 2] >= 250)
                    clipped++;
            }
        }

        return 2 * clipped >= all;
    }
}
