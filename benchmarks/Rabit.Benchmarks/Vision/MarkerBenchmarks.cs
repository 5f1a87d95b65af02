using System;
using System.IO;
using BenchmarkDotNet.Attributes;
using Rabit.Vision;

namespace Rabit.Benchmarks.Vision;

/// <summary>
/// Finding the markers of both families in one picture of 640 x 480 and one of 1640 x 1232; <c>eng/vision-speed.sh</c>
/// measures OpenCV's detector on more of them in turn.
/// </summary>
[MemoryDiagnoser]
public class MarkerBenchmarks
{
    private readonly MarkerDetector _detector = new();
    private RgbPicture? _picture;
    private byte[] _grey = [];

    [Params("stills_640_f0018.jpg", "stills_1640_f0014.jpg")]
    public string File { get; set; } = "";

    [GlobalSetup]
    public void Open()
    {
        _picture = new PictureReader().Load(Path.Combine(AppContext.BaseDirectory, "data", File));
        _grey = new byte[_picture.Width * _picture.Height];
        if (Grey() + Find() != _grey.Length + 2)
            throw new InvalidOperationException("Both pictures have two markers that are found.");
    }

    [Benchmark]
    public int Grey()
    {
        GreyPixels.FromRgb(_picture!.Pixels, _grey);
        return _grey.Length;
    }

    [Benchmark]
    public int Find() => _detector.Find(_grey, _picture!.Width, _picture.Height).Length;

    /// <summary>What no detector goes below: every pixel is read once.</summary>
    [Benchmark(Baseline = true)]
    public int ReadOnce() => _grey.AsSpan().IndexOfAnyExceptInRange((byte)0, (byte)255);
}
