using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using Rabit.Vision;

namespace VisionBench;

/// <summary>Reads the markers of both families in pictures.</summary>
internal sealed class MarkerBench(int repeats)
{
    private readonly PictureReader _reader = new();
    private readonly MarkerDetector _detector = new();
    private byte[] _grey = [];

    /// <summary>Time in the detector so far.</summary>
    public TimeSpan Time { get; private set; }

    /// <exception cref="IOException">A picture cannot be read.</exception>
    public IEnumerable<MarkerScore> Run(MarkerPictureSet set, Action<int, int> onProgress)
    {
        foreach (MarkerPicture picture in set.Pictures)
        {
            RgbPicture pixels = _reader.Load(picture.FilePath);
            yield return Search(picture, pixels.Pixels, pixels.Width, pixels.Height);
            onProgress(picture.Index, set.Pictures.Length);
        }
    }

    /// <summary>Searches pixels in colour. The shortest of the repeats counts.</summary>
    public MarkerScore Search(MarkerPicture picture, byte[] pixels, int width, int height)
    {
        int size = width * height;
        if (_grey.Length < size)
            _grey = new byte[size];
        GreyPixels.FromRgb(pixels.AsSpan(0, size * 3), _grey);
        long shortest = long.MaxValue;
        DetectedMarker[] read = [];
        for (int i = 0; i < repeats; i++)
        {
            long start = Stopwatch.GetTimestamp();
            ReadOnlySpan<DetectedMarker> found = _detector.Find(_grey, width, height);
            shortest = Math.Min(shortest, Stopwatch.GetTimestamp() - start);
            read = found.ToArray();
        }

        Time += TimeSpan.FromTicks((long)(shortest * (double)TimeSpan.TicksPerSecond / Stopwatch.Frequency));
        return new MarkerScore(picture, width, height, read);
    }
}
