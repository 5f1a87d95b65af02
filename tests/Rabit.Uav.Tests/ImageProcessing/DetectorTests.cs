using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

public sealed class DetectorTests
{
    private static readonly TargetColours[] Colours =
        [TargetColours.Red, TargetColours.Orange, TargetColours.Blue, TargetColours.Yellow, TargetColours.Magenta];

    private readonly Detector _detector = new(new ImageProcessingOptions());

    [Theory]
    [InlineData(5, 0.9, 0.2)]
    [InlineData(8, 0.99, 0.1)]
    [InlineData(13, 1, 0.1)]
    [InlineData(30, 1, 0.1)]
    public void Search_PanelsAnyhow_FindsThemWhereTheyAre(double sidePixels, double leastRecall, double mostError)
    {
        const int Pictures = 12;
        int seed = 100 + (int)sidePixels;
        (int shown, int found, int wrong, double squares) = (0, 0, 0, 0);
        for (int n = 0; n < Pictures; n++)
        {
            var random = new Random(seed + n);
            var painting = new Painting(seed + n);
            List<(TargetColours Colour, double X, double Y)> panels = Scatter(painting, random, sidePixels, light: 1);
            List<Detection> detections = Search(painting.Finish(), sidePixels);
            shown += panels.Count;
            foreach (Detection d in detections)
            {
                (TargetColours colour, double x, double y) = panels.OrderBy(p => Distance(p.X, p.Y, d)).First();
                if (colour != d.Colour || Distance(x, y, d) > sidePixels / 2)
                {
                    wrong++;
                    continue;
                }

                found++;
                squares += Distance(x, y, d) * Distance(x, y, d);
                Assert.InRange(d.SideMetres, 0.8, 1.2);
                Assert.InRange(d.Score, 0.3, 1);
            }
        }

        string what = $"seed {seed}: {found} of {shown} found, {wrong} wrong";
        Assert.True(found >= leastRecall * shown, what);
        Assert.True(wrong == 0, what);
        double rms = Math.Sqrt(squares / found);
        Assert.True(rms < mostError, $"seed {seed}: off by {rms} pixels");
    }

    [Theory]
    [InlineData(0.65)]
    [InlineData(0.8)]
    [InlineData(1.1)]
    public void Search_ShadeOrBrightLight_FindsThemAll(double light)
    {
        const int Seed = 40;
        var painting = new Painting(Seed);
        List<(TargetColours Colour, double X, double Y)> panels = Scatter(painting, new Random(Seed), 13, light);
        List<Detection> found = Search(painting.Finish(), 13);
        Assert.True(found.Count == panels.Count, $"seed {Seed}: {found.Count} of {panels.Count}");
        Assert.All(found, d => Assert.Contains(panels, p => p.Colour == d.Colour && Distance(p.X, p.Y, d) < 1));
    }

    [Fact]
    public void Search_NearColoursAndWrongForms_FindsNone()
    {
        ((double, double, double) Colour, double Length, double Width)[] things =
        [
            ((122, 64, 42), 1.1, 0.9), ((84, 100, 134), 1.2, 1), ((204, 184, 118), 1, 1), ((134, 58, 54), 1, 1), ((136, 92, 126), 1.2, 1.1),
            ((176, 112, 78), 1, 1.2), (Painting.Nominal(TargetColours.Red), 0.25, 0.25), (Painting.Nominal(TargetColours.Orange), 3, 0.3),
            (Painting.Nominal(TargetColours.Blue), 0.25, 0.25), (Painting.Nominal(TargetColours.Yellow), 3, 0.3),
            (Painting.Nominal(TargetColours.Magenta), 3, 3), (Painting.Nominal(TargetColours.Red), 2.2, 0.9),
        ];
        const int Seed = 300;
        foreach (double pixels in new[] { 8.0, 13, 30 })
        {
            for (int n = 0; n < 4; n++)
            {
                var random = new Random(Seed + n);
                var painting = new Painting(Seed + n);
                for (int i = 0; i < things.Length; i++)
                {
                    double light = 1 + (0.1 * random.NextDouble());
                    (double r, double g, double b) = things[i].Colour;
                    painting.Rectangle(
                        (r * light, g * light, b * light),
                        80 + (i % 4 * 155) + (20 * random.NextDouble()),
                        85 + (i / 4 * 150) + (20 * random.NextDouble()),
                        things[i].Length * pixels,
                        things[i].Width * pixels,
                        Math.PI * random.NextDouble());
                }

                List<Detection> found = Search(painting.Finish(), pixels);
                Assert.True(found.Count == 0, $"seed {Seed + n}, {pixels} pixels: {string.Join(", ", found.Select(d => $"{d.Colour} at {d.CentreX:F0},{d.CentreY:F0} {d.SideMetres:F2} m"))}");
            }
        }
    }

    [Fact]
    public void Search_PanelCutByTheBorder_IsNotReported()
    {
        for (double x = -8; x <= 12; x += 0.5)
        {
            var painting = new Painting(1, noise: 0);
            painting.Panel(TargetColours.Red, x, 100, 13, 0);
            painting.Panel(TargetColours.Blue, Painting.Width - 1 - x, 200, 13, 0);
            painting.Panel(TargetColours.Yellow, 200, x, 13, 0);
            painting.Panel(TargetColours.Magenta, 300, Painting.Height - 1 - x, 13, 0);
            int found = Search(painting.Finish(), 13).Count;

            // A whole panel, half of 13 pixels and a margin for its edge away from the border, is found; a cut one never.
            if (x >= 10)
                Assert.Equal(4, found);
            if (x < 6)
                Assert.Equal(0, found);
        }
    }

    [Fact]
    public void Search_OnlySomeColours_FindsThoseAlone()
    {
        var painting = new Painting(5);
        for (int i = 0; i < Colours.Length; i++)
            painting.Panel(Colours[i], 100 + (80 * i), 200, 13, 0.3);
        byte[] picture = painting.Finish();

        Assert.Equal(5, Search(picture, 13).Count);
        Assert.Equal([TargetColours.Orange], Search(picture, 13, TargetColours.Orange).Select(d => d.Colour));
        Assert.Equal(2, Search(picture, 13, TargetColours.Blue | TargetColours.Red).Count);
        Assert.Empty(Search(picture, 13, TargetColours.None));
        Assert.Equal(5, Search(picture, 13).Count);
    }

    [Fact]
    public void Search_PanelsSideBySide_AreTwo()
    {
        var painting = new Painting(6);
        painting.Panel(TargetColours.Red, 100, 100, 13, 0);
        painting.Panel(TargetColours.Red, 117, 100, 13, 0);
        painting.Panel(TargetColours.Red, 300, 100, 13, 0);
        painting.Panel(TargetColours.Blue, 313, 100, 13, 0);
        Assert.Equal(4, Search(painting.Finish(), 13).Count);
    }

    [Fact]
    public void Search_ThingWithAHole_IsNoTarget()
    {
        var painting = new Painting(6);
        painting.Panel(TargetColours.Red, 100, 100, 18, 0);
        painting.Rectangle((86, 112, 56), 100, 100, 12, 12, 0);
        Assert.Empty(Search(painting.Finish(), 13));
    }

    [Fact]
    public void Search_MoreThanAreReported_KeepsTheSurestAndCountsTheRest()
    {
        var painting = new Painting(8);
        for (int i = 0; i < 24; i++)
            painting.Panel(Colours[i % 5], 50 + (i % 8 * 70), 80 + (i / 8 * 120), 10 + (i % 5), 0.1 * i);
        byte[] picture = painting.Finish();

        List<Detection> found = Search(picture, 13);

        Assert.Equal(16, found.Count);
        Assert.Equal(8, _detector.Cut);
        Assert.Equal(found.OrderByDescending(d => d.Score).Select(d => d.CentreX), found.Select(d => d.CentreX));
    }

    [Fact]
    public void Search_NothingButColouredNoise_SaysThatItCouldNotSearch()
    {
        var random = new Random(9);
        var picture = new byte[Painting.Width * Painting.Height * 3];
        for (int i = 0; i < picture.Length; i += 3)
        {
            (double r, double g, double b) = random.Next(3) == 0 ? Painting.Nominal(Colours[random.Next(5)]) : (86, 112, 56);
            (picture[i], picture[i + 1], picture[i + 2]) = ((byte)r, (byte)g, (byte)b);
        }

        Assert.False(_detector.TrySearch(picture, Painting.Width, Painting.Height, TargetColours.All, Over(13)));
        Assert.True(_detector.Found.IsEmpty);
    }

    [Fact]
    public void Search_OneColourAllOver_FindsNone()
    {
        var painting = new Painting(10);
        painting.Rectangle(Painting.Nominal(TargetColours.Red), 320, 240, 700, 700, 0);
        Assert.Empty(Search(painting.Finish(), 13));
    }

    [Fact]
    public void Search_PictureAfterPicture_AllocatesNothing()
    {
        var painting = new Painting(11);
        Scatter(painting, new Random(11), 13, light: 1);
        byte[] picture = painting.Finish();
        GroundProjection projection = Over(13);
        _detector.TrySearch(picture, Painting.Width, Painting.Height, TargetColours.All, projection);

        Assert.Equal(0, Allocated.By(() =>
        {
            _detector.TrySearch(picture, Painting.Width, Painting.Height, TargetColours.Red, projection);
            _detector.TrySearch(picture, Painting.Width, Painting.Height, TargetColours.All, projection);
        }));
        Assert.False(_detector.Found.IsEmpty);
    }

    [Fact]
    public void Blobs_RandomPictures_AreThoseOfAFloodFill()
    {
        const int Seed = 77;
        var random = new Random(Seed);
        var table = new ColourTable(NominalColours.Ranges);
        table.Select((uint)TargetColours.All);
        var finder = new BlobFinder();
        for (int n = 0; n < 200; n++)
        {
            (int width, int height) = (1 + random.Next(24), 1 + random.Next(24));
            int[] classes = Enumerable.Range(0, width * height).Select(_ => Math.Max(0, random.Next(n % 5 + 2) - 1)).ToArray();
            byte[] picture = classes.SelectMany(c =>
            {
                (double r, double g, double b) = c == 0 ? (86, 112, 56) : Painting.Nominal(Colours[c - 1]);
                return new[] { (byte)r, (byte)g, (byte)b };
            }).ToArray();
            Assert.True(finder.TryFind(picture, width, height, table));
            IEnumerable<string> found = finder.Blobs.ToArray().Select(b => $"{b.Class}: {b.Left}-{b.Right} {b.Top}-{b.Bottom} {b.Pixels}");
            Assert.Equal(Flooded(classes, width, height).OrderBy(s => s, StringComparer.Ordinal), found.OrderBy(s => s, StringComparer.Ordinal));
        }
    }

    private static List<string> Flooded(int[] classes, int width, int height)
    {
        var blobs = new List<string>();
        int[] left = (int[])classes.Clone();
        for (int start = 0; start < left.Length; start++)
        {
            int colour = left[start];
            if (colour == 0)
                continue;
            var members = new List<int>();
            var open = new Stack<int>([start]);
            left[start] = 0;
            while (open.Count > 0)
            {
                int at = open.Pop();
                members.Add(at);
                for (int d = 0; d < 9; d++)
                {
                    (int x, int y) = ((at % width) + (d % 3) - 1, (at / width) + (d / 3) - 1);
                    if (x < 0 || y < 0 || x >= width || y >= height || left[(y * width) + x] != colour)
                        continue;
                    left[(y * width) + x] = 0;
                    open.Push((y * width) + x);
                }
            }

            blobs.Add($"{colour}: {members.Min(m => m % width)}-{members.Max(m => m % width)} {members.Min(m => m / width)}-{members.Max(m => m / width)} {members.Count}");
        }

        return blobs;
    }

    private static List<(TargetColours Colour, double X, double Y)> Scatter(Painting painting, Random random, double side, double light)
    {
        var panels = new List<(TargetColours, double, double)>();
        for (int i = 0; i < 10; i++)
        {
            TargetColours colour = Colours[i % 5];
            double x = 70 + (i % 5 * 120) + (30 * random.NextDouble());
            double y = 130 + (i / 5 * 200) + (30 * random.NextDouble());
            painting.Panel(colour, x, y, side, Math.PI * random.NextDouble(), light * (0.95 + (0.1 * random.NextDouble())));
            panels.Add((colour, x, y));
        }

        return panels;
    }

    // From so high that a metre is so many pixels.
    private static GroundProjection Over(double pixelsPerMetre)
    {
        var view = new TestView();
        view.Position = GeodeticPosition.FromRadians(0.8, 0.1, view.GroundAltitude + (view.Camera.FocalX / pixelsPerMetre));
        return view.Projection(new ErrorBudget());
    }

    private static double Distance(double x, double y, Detection d) => Math.Sqrt(((x - d.CentreX) * (x - d.CentreX)) + ((y - d.CentreY) * (y - d.CentreY)));

    private List<Detection> Search(byte[] picture, double pixelsPerMetre, TargetColours colours = TargetColours.All)
    {
        Assert.True(_detector.TrySearch(picture, Painting.Width, Painting.Height, colours, Over(pixelsPerMetre)));
        return [.. _detector.Found.ToArray()];
    }
}
