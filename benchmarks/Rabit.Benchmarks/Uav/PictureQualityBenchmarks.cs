using System;
using BenchmarkDotNet.Attributes;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Quality;
using Rabit.Uav.Messages;

namespace Rabit.Benchmarks.Uav;

/// <summary>
/// Judging a picture beside searching it, the same picture of ground of 640 x 480: it shall cost less than a tenth.
/// </summary>
public class PictureQualityBenchmarks
{
    private const int Width = 640;
    private const int Height = 480;

    private readonly ShapeTargetDetector _detector = new(TargetClass.Defaults);
    private readonly TargetDetection[] _found = new TargetDetection[16];
    private readonly PictureJudge _judge = new();
    private readonly byte[] _grass = Paint();
    private PictureView _view = new()
    {
        Centre = GeodeticPosition.FromRadians(0.8, 0.1, 500),
        GroundSamplingMetres = 0.075,
        NeededSamplingMetres = 0.15,
    };

    [Benchmark(Baseline = true)]
    public int Detect()
    {
        var input = new DetectorInput(
            _grass, Width, Height, TargetClass.Defaults, PictureGroundScale.Uniform(0.075));
        return _detector.Detect(input, _found).Count;
    }

    [Benchmark]
    public int Judge() => (int)_judge.Judge(_grass, Width, Height, _view);

    private static byte[] Paint()
    {
        var random = new Random(1);
        var picture = new byte[Width * Height * 3];
        for (int at = 0; at < picture.Length; at += 3)
        {
            int x = at / 3 % Width;
            int y = at / 3 / Width;
            int blade = random.Next(-12, 13) + (int)(14 * Math.Sin(x * 0.4) * Math.Cos(y * 0.3));
            (picture[at], picture[at + 1], picture[at + 2]) =
                ((byte)(86 + blade), (byte)(112 + blade), (byte)(56 + (blade / 2)));
        }

        return picture;
    }
}
