using System;
using System.Collections.Immutable;
using BenchmarkDotNet.Attributes;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Benchmarks.Uav;

/// <summary>
/// Searching a picture of 640 x 480 for targets, from 40 m above: bare grass, five panels, and a meadow full of
/// coloured spots.
/// </summary>
public class DetectorBenchmarks
{
    private const int Width = 640;
    private const int Height = 480;

    private static readonly ImmutableArray<TargetClass> Flag =
    [
        new TargetClass("flag")
        {
            Colour = new ColourRange(28, 72, 205), SecondColour = new ColourRange(243, 214, 28),
        },
    ];

    private readonly ShapeTargetDetector _detector = new(TargetClass.Defaults);
    private readonly PanelTargetDetector _twoColours = new(Flag);
    private readonly TargetDetection[] _found = new TargetDetection[16];
    private readonly NadirScale _scale = new();
    private readonly byte[] _grass = Paint(panels: 0, spots: 0);
    private readonly byte[] _panels = Paint(panels: 5, spots: 0);
    private readonly byte[] _meadow = Paint(panels: 5, spots: 3000);

    [GlobalSetup]
    public void Check()
    {
        if (Grass() != 0 || Panels() != 5)
            throw new InvalidOperationException($"Found {Grass()} panels on bare grass and {Panels()} of 5.");
    }

    [Benchmark(Baseline = true)]
    public int Grass() => Search(_grass);

    [Benchmark]
    public int Panels() => Search(_panels);

    /// <summary>For one class of panels of two hues, by their detector, which runs beside that of forms.</summary>
    [Benchmark]
    public int TwoColours() => Search(_panels, _twoColours, Flag);

    [Benchmark]
    public int Meadow() => Search(_meadow);

    private static byte[] Paint(int panels, int spots)
    {
        var random = new Random(1);
        var picture = new byte[Width * Height * 3];
        for (int at = 0; at < picture.Length; at += 3)
        {
            int blade = random.Next(-20, 21);
            (picture[at], picture[at + 1], picture[at + 2]) =
                ((byte)(86 + blade), (byte)(112 + blade), (byte)(56 + (blade / 2)));
        }

        for (int n = 0; n < panels; n++)
            Square(picture, 80 + (110 * n), 150 + (40 * n), side: 13);
        for (int n = 0; n < spots; n++)
            Square(picture, 5 + random.Next(Width - 10), 5 + random.Next(Height - 10), side: 2);
        return picture;
    }

    private static void Square(byte[] picture, int left, int top, int side)
    {
        for (int n = 0; n < side * side; n++)
        {
            int at = (((top + (n / side)) * Width) + left + (n % side)) * 3;
            (picture[at], picture[at + 1], picture[at + 2]) = (205, 28, 32);
        }
    }

    private int Search(byte[] picture) => Search(picture, _detector, TargetClass.Defaults);

    private int Search(byte[] picture, ITargetDetector detector, ImmutableArray<TargetClass> classes)
    {
        var input = new DetectorInput(picture, Width, Height, classes, new PictureGroundScale(_scale));
        return detector.Detect(input, _found).Count;
    }

    private sealed class NadirScale : IGroundScaleSource
    {
        private readonly GroundProjection _projection = NadirView.CreateProjection();

        public bool TryScale(double column, double row, out GroundScale scale)
            => _projection.TryScale(column, row, out scale);
    }
}
