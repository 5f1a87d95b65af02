using System;
using System.IO;
using System.Linq;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Rabit.Vision.Tests;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// Panels of the five default colours, 1 m, pasted into crops of real ground in three lights: what both detectors find.
/// </summary>
[Trait("Category", "Long")]
public sealed class PastedPanelsTests(ITestOutputHelper output)
{
    private const int Samples = 8;

    // Linear gains of red, green, blue: of dusk, by what light of 8000 K is against one of 6500 K.
    private static readonly (string Name, double[] Gains)[] Lights =
    [
        ("as it is", [1, 1, 1]), ("dusk", [0.27, 0.3, 0.342]), ("bright", [1.7, 1.7, 1.7]),
    ];

    private static readonly (TargetClassName Class, double[] Colour)[] Panels =
    [
        (DefaultTargetClasses.Red, [205, 28, 32]), (DefaultTargetClasses.Orange, [242, 112, 18]),
        (DefaultTargetClasses.Blue, [28, 72, 205]), (DefaultTargetClasses.Yellow, [243, 214, 28]),
        (DefaultTargetClasses.Magenta, [212, 36, 150]),
    ];

    private readonly TargetDetection[] _found = new TargetDetection[64];

    [RealPicturesFact("background")]
    public void Detect_ByForm_FindsPanelsInEachLight()
        => CountAll(new ShapeTargetDetector(TargetClass.Defaults), maxOthers: 1);

    // What was found besides, in 30 crops, is limited by what was measured.
    private void CountAll(ITargetDetector detector, int maxOthers)
    {
        string[] crops = Directory.GetFiles(RealPicturesFactAttribute.FolderOf("background")!, "bg_*");
        foreach ((string light, double[] gains) in Lights)
        {
            foreach (double side in new[] { 7.0, 10, 28 })
            {
                int[] found = new int[Panels.Length];
                int others = crops.Sum(crop => Count(detector, crop, gains, side, found));
                double share = found.Sum() / (double)(Panels.Length * crops.Length);
                output.WriteLine(FormattableString.Invariant($"{light}, {side} px: {share:F3}, {others} others; ")
                    + string.Join(" ", found) + $" of {crops.Length} each");
                Assert.InRange(share, 0.95, 1);
                Assert.InRange(others, 0, maxOthers);
            }
        }
    }

    // Returns how many detections are none of the panels.
    private int Count(ITargetDetector detector, string crop, double[] gains, double side, int[] found)
    {
        RgbPicture picture = PictureFile.Load(crop);
        byte[] pixels = (byte[])picture.Pixels.Clone();
        var random = new Random((int)side);
        (double X, double Y)[] places = PlacesIn(picture, side, random);
        for (int i = 0; i < Panels.Length; i++)
        {
            Paste(pixels, picture.Width, picture.Height, places[i], side, random.NextDouble() * Math.PI / 2,
                Panels[i].Colour);
        }

        Relight(pixels, gains, random);
        DetectorResult result = detector.Detect(
            new DetectorInput(
                pixels, picture.Width, picture.Height, TargetClass.Defaults, PictureGroundScale.Uniform(1 / side)),
            _found);
        Assert.Null(result.Refusal);
        int right = 0;
        for (int i = 0; i < Panels.Length; i++)
        {
            bool isFound = _found.Take(result.Count).Any(d => d.Class == Panels[i].Class
                && Math.Abs(d.CentreX - places[i].X) < side / 2 && Math.Abs(d.CentreY - places[i].Y) < side / 2);
            found[i] += isFound ? 1 : 0;
            right += isFound ? 1 : 0;
            if (!isFound)
                output.WriteLine($"  {Path.GetFileName(crop)}: no {Panels[i].Class} at {places[i]}");
        }

        return result.Count - right;
    }

    // Each in a strip of its own.
    private static (double X, double Y)[] PlacesIn(RgbPicture picture, double side, Random random)
    {
        double strip = picture.Width / (double)Panels.Length;
        double margin = Math.Min((strip / 2) - 1, 1.5 * side);
        return Enumerable.Range(0, Panels.Length).Select(i => (
            (i * strip) + margin + (random.NextDouble() * (strip - (2 * margin))),
            (2 * side) + (random.NextDouble() * (picture.Height - (4 * side))))).ToArray();
    }

    // The part of each pixel that is covered, by samples, and a little blur of the lens.
    private static void Paste(
        byte[] pixels, int width, int height, (double X, double Y) centre, double side, double turn, double[] colour)
    {
        (double sin, double cos) = (Math.Sin(turn), Math.Cos(turn));
        int reach = (int)side + 2;
        for (int y = Math.Max(0, (int)centre.Y - reach); y <= Math.Min(height - 1, (int)centre.Y + reach); y++)
        {
            for (int x = Math.Max(0, (int)centre.X - reach); x <= Math.Min(width - 1, (int)centre.X + reach); x++)
            {
                int covered = 0;
                for (int k = 0; k < Samples * Samples; k++)
                {
                    // 1.6 pixels wide: the pixel and the blur.
                    double dx = x + (1.6 * ((((k % Samples) + 0.5) / Samples) - 0.5)) - centre.X;
                    double dy = y + (1.6 * ((((k / Samples) + 0.5) / Samples) - 0.5)) - centre.Y;
                    if (Math.Max(Math.Abs((dx * cos) + (dy * sin)), Math.Abs((dy * cos) - (dx * sin))) <= side / 2)
                        covered++;
                }

                double part = covered / (double)(Samples * Samples);
                for (int c = 0; part > 0 && c < 3; c++)
                {
                    int at = (3 * ((y * width) + x)) + c;
                    pixels[at] = FromLinear((part * ToLinear(colour[c])) + ((1 - part) * ToLinear(pixels[at])), 0);
                }
            }
        }
    }

    private static void Relight(byte[] pixels, double[] gains, Random random)
    {
        for (int i = 0; i < pixels.Length; i++)
            pixels[i] = FromLinear(gains[i % 3] * ToLinear(pixels[i]), 3 * (random.NextDouble() - 0.5));
    }

    private static double ToLinear(double level) => Math.Pow(level / 255, 2.2);

    private static byte FromLinear(double value, double noise)
        => (byte)Math.Max(0, Math.Min(255, Math.Round((255 * Math.Pow(value, 1 / 2.2)) + noise)));
}
