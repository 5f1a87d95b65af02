using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Panels of one colour, the default classes, on painted pictures.</summary>
public sealed class PaintedPanelsTests
{
    private static readonly TargetClassName[] Names = [.. DefaultTargetClasses.All];

    private readonly ShapeTargetDetector _detector = new(TargetClass.Defaults);
    private readonly TargetDetection[] _found = new TargetDetection[16];

    [Theory]
    [InlineData(5, 0.9, 0.2)]
    [InlineData(8, 0.99, 0.1)]
    [InlineData(13, 1, 0.1)]
    [InlineData(30, 1, 0.1)]
    public void Detect_PanelsAnyhow_FindsThemWhereTheyAre(double sidePixels, double leastRecall, double mostError)
    {
        const int Pictures = 12;
        int seed = 100 + (int)sidePixels;
        (int shown, int found, int wrong, double squares) = (0, 0, 0, 0);
        for (int n = 0; n < Pictures; n++)
        {
            var random = new Random(seed + n);
            var painting = new Painting(seed + n);
            List<(TargetClassName Class, double X, double Y)> panels = Scatter(painting, random, sidePixels, light: 1);
            List<TargetDetection> detections = Search(painting.Finish(), sidePixels);
            shown += panels.Count;
            foreach (TargetDetection d in detections)
            {
                (TargetClassName targetClass, double x, double y) = panels.OrderBy(p => Distance(p.X, p.Y, d)).First();
                if (targetClass != d.Class || Distance(x, y, d) > sidePixels / 2)
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
    public void Detect_ShadeOrBrightLight_FindsThemAll(double light)
    {
        const int Seed = 40;
        var painting = new Painting(Seed);
        List<(TargetClassName Class, double X, double Y)> panels = Scatter(painting, new Random(Seed), 13, light);
        List<TargetDetection> found = Search(painting.Finish(), 13);
        Assert.True(found.Count == panels.Count, $"seed {Seed}: {found.Count} of {panels.Count}");
        Assert.All(found, d => Assert.Contains(panels, p => p.Class == d.Class && Distance(p.X, p.Y, d) < 1));
    }

    [Fact]
    public void Detect_NearColoursAndWrongForms_FindsNone()
    {
        ((double, double, double) Colour, double Length, double Width)[] things =
        [
            ((122, 64, 42), 1.1, 0.9), ((84, 100, 134), 1.2, 1), ((204, 184, 118), 1, 1), ((134, 58, 54), 1, 1),
            ((136, 92, 126), 1.2, 1.1),
            ((176, 112, 78), 1, 1.2), (Painting.Nominal(DefaultTargetClasses.Red), 0.25, 0.25),
            (Painting.Nominal(DefaultTargetClasses.Orange), 3, 0.3),
            (Painting.Nominal(DefaultTargetClasses.Blue), 0.25, 0.25),
            (Painting.Nominal(DefaultTargetClasses.Yellow), 3, 0.3),
            (Painting.Nominal(DefaultTargetClasses.Magenta), 3, 3),
            (Painting.Nominal(DefaultTargetClasses.Red), 2.2, 0.9),
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

                List<TargetDetection> found = Search(painting.Finish(), pixels);
                Assert.True(
                    found.Count == 0,
                    $"seed {Seed + n}, {pixels} pixels: {string.Join(", ", found.Select(d => $"{d.Class} at {d.CentreX:F0},{d.CentreY:F0} {d.SideMetres:F2} m"))}");
            }
        }
    }

    /// <summary>Deep shade in the picture is taken for haze, which makes pale colours of bright ones.</summary>
    [Fact]
    public void Detect_DullCrateWhereSomeOfTheGroundIsDark_IsNoPanel()
    {
        var painting = new Painting(15);
        painting.Rectangle((50, 56, 40), 100, 400, 120, 60, 0);
        painting.Rectangle((132, 54, 50), 300, 200, 13, 13, 0.3);
        painting.Panel(DefaultTargetClasses.Red, 450, 200, 13, 0.3, light: 0.7);

        TargetDetection found = Assert.Single(Search(painting.Finish(), 13));
        Assert.Equal(450, found.CentreX, 1.0);
    }

    [Fact]
    public void Detect_PanelCutByTheBorder_IsNotReported()
    {
        for (double x = -8; x <= 12; x += 0.5)
        {
            var painting = new Painting(1, noise: 0);
            painting.Panel(DefaultTargetClasses.Red, x, 100, 13, 0);
            painting.Panel(DefaultTargetClasses.Blue, Painting.Width - 1 - x, 200, 13, 0);
            painting.Panel(DefaultTargetClasses.Yellow, 200, x, 13, 0);
            painting.Panel(DefaultTargetClasses.Magenta, 300, Painting.Height - 1 - x, 13, 0);
            int found = Search(painting.Finish(), 13).Count;

            // A whole panel, half of 13 pixels and a margin for its edge away from the border, is found; a cut one
            // never.
            if (x >= 10)
                Assert.Equal(4, found);
            if (x < 6)
                Assert.Equal(0, found);
        }
    }

    [Fact]
    public void Detect_OnlySomeClasses_FindsThoseAlone()
    {
        var painting = new Painting(5);
        for (int i = 0; i < Names.Length; i++)
            painting.Panel(Names[i], 100 + (80 * i), 200, 13, 0.3);
        byte[] picture = painting.Finish();

        Assert.Equal(5, Search(picture, 13).Count);
        Assert.Equal(
            [DefaultTargetClasses.Orange], Search(picture, 13, DefaultTargetClasses.Orange).Select(d => d.Class));
        Assert.Equal(2, Search(picture, 13, DefaultTargetClasses.Blue, DefaultTargetClasses.Red).Count);
        Assert.Empty(Search(picture, 13, new TargetClassName("person")));
        Assert.Equal(5, Search(picture, 13).Count);
    }

    [Fact]
    public void Detect_PanelsSideBySide_AreTwo()
    {
        var painting = new Painting(6);
        painting.Panel(DefaultTargetClasses.Red, 100, 100, 13, 0);
        painting.Panel(DefaultTargetClasses.Red, 117, 100, 13, 0);
        painting.Panel(DefaultTargetClasses.Red, 300, 100, 13, 0);
        painting.Panel(DefaultTargetClasses.Blue, 313, 100, 13, 0);
        Assert.Equal(4, Search(painting.Finish(), 13).Count);
    }

    [Fact]
    public void Detect_ThingWithAHole_IsNoTarget()
    {
        var painting = new Painting(6);
        painting.Panel(DefaultTargetClasses.Red, 100, 100, 18, 0);
        painting.Rectangle((86, 112, 56), 100, 100, 12, 12, 0);
        Assert.Empty(Search(painting.Finish(), 13));
    }

    [Fact]
    public void Detect_MoreThanAreReported_KeepsTheBestAndCountsTheRest()
    {
        var painting = new Painting(8);
        for (int i = 0; i < 24; i++)
            painting.Panel(Names[i % 5], 50 + (i % 8 * 70), 80 + (i / 8 * 120), 10 + (i % 5), 0.1 * i);
        byte[] picture = painting.Finish();

        DetectorResult result = _detector.Detect(Input(picture, 13), _found);

        Assert.Equal(DetectorResult.Found(16, dropped: 8), result);
        TargetDetection[] found = _found;
        Assert.Equal(found.OrderByDescending(d => d.Score).Select(d => d.CentreX), found.Select(d => d.CentreX));
    }

    [Fact]
    public void Detect_NothingButColouredNoise_FindsNone()
    {
        var random = new Random(9);
        var picture = new byte[Painting.Width * Painting.Height * 3];
        for (int i = 0; i < picture.Length; i += 3)
        {
            (double r, double g, double b) = random.Next(3) == 0
                ? Painting.Nominal(Names[random.Next(5)])
                : (86, 112, 56);
            (picture[i], picture[i + 1], picture[i + 2]) = ((byte)r, (byte)g, (byte)b);
        }

        Assert.Empty(Search(picture, 13));
    }

    [Fact]
    public void Detect_OneColourAllOver_FindsNone()
    {
        var painting = new Painting(10);
        painting.Rectangle(Painting.Nominal(DefaultTargetClasses.Red), 320, 240, 700, 700, 0);
        Assert.Empty(Search(painting.Finish(), 13));
    }

    [Fact]
    public void Detect_PictureAfterPicture_AllocatesNothing()
    {
        var painting = new Painting(11);
        Scatter(painting, new Random(11), 13, light: 1);
        byte[] picture = painting.Finish();
        DetectorInput all = Input(picture, 13);
        DetectorInput red = Input(picture, 13, DefaultTargetClasses.Red);
        _detector.Detect(all, _found);

        int count = 0;
        Assert.Equal(0, Allocated.By(() =>
        {
            _detector.Detect(red, _found);
            count = _detector.Detect(all, _found).Count;
        }));
        Assert.NotEqual(0, count);
    }

    [Fact]
    public void Detect_PixelsThatAreNotTheStartOfAnArray_AreSearchedToo()
    {
        var painting = new Painting(12);
        painting.Panel(DefaultTargetClasses.Red, 100, 100, 13, 0.2);
        byte[] picture = painting.Finish();
        var shifted = new byte[picture.Length + 7];
        picture.CopyTo(shifted, 7);
        var input = new DetectorInput(
            shifted.AsMemory(7), Painting.Width, Painting.Height, TargetClass.Defaults,
            PictureGroundScale.Uniform(1.0 / 13));

        Assert.Equal(1, _detector.Detect(input, _found).Count);
        Assert.Equal(100, _found[0].CentreX, 0.2);
    }

    [Fact]
    public void Detect_ClassesOfOtherSizesAndColours_AreTheUsers()
    {
        ImmutableArray<TargetClass> classes =
        [
            new("buoy") { Colour = new ColourRange(242, 112, 18), MinSideMetres = 0.2, MaxSideMetres = 0.5 },
            new("raft") { Colour = new ColourRange(243, 214, 28), MinSideMetres = 2, MaxSideMetres = 5 },
            new("car") { Colour = new ColourRange(28, 72, 205), MinSideMetres = 2, MaxSideMetres = 5 },
        ];
        var detector = new ShapeTargetDetector(classes);
        var painting = new Painting(13);
        painting.Panel(DefaultTargetClasses.Orange, 100, 100, 9, 0.2);
        painting.Panel(DefaultTargetClasses.Blue, 300, 100, 60, 0.2);
        painting.Panel(DefaultTargetClasses.Blue, 500, 100, 9, 0.2);
        var input = new DetectorInput(
            painting.Finish(), Painting.Width, Painting.Height, classes, PictureGroundScale.Uniform(0.04));

        int count = detector.Detect(input, _found).Count;

        Assert.Equal(
            ["buoy", "car"],
            _found.Take(count).Select(d => d.Class.ToString()).OrderBy(n => n, StringComparer.Ordinal));
    }

    [Fact]
    public void Constructor_ClassWithoutColourOrTooMany_IsRefused()
    {
        Assert.Contains(
            "person has no colour",
            Assert.Throws<ArgumentException>(() => new ShapeTargetDetector([new TargetClass("person")])).Message,
            StringComparison.Ordinal);
        ImmutableArray<TargetClass> many =
        [
            .. Enumerable.Range(0, 65)
                .Select(i => new TargetClass($"class {i}") { Colour = new ColourRange(205, 28, 32) })
        ];
        Assert.Contains(
            "at most 64", Assert.Throws<ArgumentException>(() => new ShapeTargetDetector(many)).Message,
            StringComparison.Ordinal);
    }

    private static List<(TargetClassName Class, double X, double Y)> Scatter(
        Painting painting, Random random, double side, double light)
    {
        var panels = new List<(TargetClassName, double, double)>();
        for (int i = 0; i < 10; i++)
        {
            TargetClassName targetClass = Names[i % 5];
            double x = 70 + (i % 5 * 120) + (30 * random.NextDouble());
            double y = 130 + (i / 5 * 200) + (30 * random.NextDouble());
            painting.Panel(
                targetClass, x, y, side, Math.PI * random.NextDouble(), light * (0.95 + (0.1 * random.NextDouble())));
            panels.Add((targetClass, x, y));
        }

        return panels;
    }

    // From so high that a metre is so many pixels.
    private static DetectorInput Input(byte[] picture, double pixelsPerMetre, params TargetClassName[] names)
    {
        var view = new TestView();
        view.Position = GeodeticPosition.FromRadians(
            0.8, 0.1, view.GroundAltitude + (view.Camera.FocalX / pixelsPerMetre));
        ImmutableArray<TargetClass> classes = names.Length == 0
            ? TargetClass.Defaults
            : [.. names.Select(
                n => TargetClass.Defaults.FirstOrDefault(c => c.Name == n) ?? new TargetClass(n.ToString()))];
        return new DetectorInput(
            picture, Painting.Width, Painting.Height, classes, new PictureGroundScale(new ScaleOfView(view)));
    }

    private static double Distance(double x, double y, TargetDetection d)
        => Math.Sqrt(((x - d.CentreX) * (x - d.CentreX)) + ((y - d.CentreY) * (y - d.CentreY)));

    private List<TargetDetection> Search(byte[] picture, double pixelsPerMetre, params TargetClassName[] names)
    {
        DetectorResult result = _detector.Detect(Input(picture, pixelsPerMetre, names), _found);
        Assert.Null(result.Refusal);
        return [.. _found.Take(result.Count).Where(d => !d.IsCut)];   // as Image Processing does
    }

    private sealed class ScaleOfView(TestView view) : IGroundScaleSource
    {
        private readonly GroundProjection _projection = view.Projection(new ErrorBudget());

        public bool TryScale(double column, double row, out GroundScale scale)
            => _projection.TryScale(column, row, out scale);
    }
}
