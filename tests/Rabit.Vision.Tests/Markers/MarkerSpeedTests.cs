using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Vision.Tests.Markers;

/// <summary>
/// How long a picture takes at most; eng/vision-speed.sh measures it beside OpenCV.
/// </summary>
public sealed class MarkerSpeedTests(ITestOutputHelper output)
{
    // A limit that only a mistake reaches: the machine may be busy.
    [Theory]
    [InlineData("stills_640", 100)]
    [InlineData("stills_1640", 600)]
    public void Find_StillPictures_TakesLittle(string set, int limitMilliseconds)
    {
        var detector = new MarkerDetector();
        (byte[] Grey, int Width, int Height)[] pictures = [.. Directory
            .GetFiles(Path.Combine(Repository.Root, "tests", "data", "markers"), set + "_*.jpg").Select(Load)];
        double[] passes = new double[3];
        for (int pass = 0; pass < passes.Length; pass++)
        {
            long begin = Stopwatch.GetTimestamp();
            foreach ((byte[] grey, int width, int height) in pictures)
                _ = detector.Find(grey, width, height);
            passes[pass] = 1000.0 * (Stopwatch.GetTimestamp() - begin) / Stopwatch.Frequency / pictures.Length;
        }

        Array.Sort(passes);
        output.WriteLine(FormattableString.Invariant(
            $"Rabit, both families, {set}: {passes[passes.Length / 2]:0.00} ms (least {passes[0]:0.00})"));
        Assert.True(passes[0] < limitMilliseconds, $"{passes[0]} ms");
    }

    private static (byte[] Grey, int Width, int Height) Load(string path)
    {
        RgbPicture picture = new PictureReader().Load(path);
        byte[] grey = new byte[picture.Width * picture.Height];
        GreyPixels.FromRgb(picture.Pixels.AsSpan(0, grey.Length * 3), grey);
        return (grey, picture.Width, picture.Height);
    }
}
