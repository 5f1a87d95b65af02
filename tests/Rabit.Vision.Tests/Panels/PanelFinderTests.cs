using System;
using System.Linq;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Vision.Tests.Panels;

/// <summary>The pixel-level part of the panels: colours, joining, outline, centroid.</summary>
public sealed class PanelFinderTests
{
    private const int Width = 96;
    private const int Height = 80;

    private static readonly ColourRange Black = new(20, 20, 20);
    private static readonly ColourRange White = new(240, 240, 240);
    private static readonly ColourRange Red = new(205, 28, 32);
    private static readonly PanelLimits Limits = new() { MinSide = 9, MaxSide = 16, UsualSide = 12 };

    private readonly PanelFinder _finder = new();

    [Fact]
    public void Find_TwoColours_MeasuresCentreSharesAndGround()
    {
        byte[] picture = Ground();
        Fill(picture, 40, 30, 12, 6, Black);
        Fill(picture, 40, 36, 12, 6, White);
        PanelShape[] found = Find(picture, new PanelColours(Black, White));

        PanelShape panel = Assert.Single(found);
        Assert.Equal(45.5, panel.CentreX, 0.1);
        Assert.Equal(35.5, panel.CentreY, 0.1);
        Assert.Equal(144, panel.OutlinePixels);
        Assert.Equal(144, panel.Area, 2.0);
        Assert.Equal((0.5, 0.5, 0.0), (panel.FirstShare, panel.SecondShare, panel.CoveredRing));
        Assert.Equal((40, 30, 12, 12), (panel.Left, panel.Top, panel.Width, panel.Height));
        Assert.Equal(24, _finder.OutlineOf(panel).Length);
        Assert.False(panel.TouchesBorder);
    }

    [Fact]
    public void Find_HueAndWhite_MeasuresBoth()
    {
        byte[] picture = Ground();
        Fill(picture, 20, 20, 6, 12, Red);
        Fill(picture, 26, 20, 6, 12, White);
        PanelShape panel = Assert.Single(Find(picture, new PanelColours(Red, White)));
        Assert.Equal((0.5, 0.5), (panel.FirstShare, panel.SecondShare));
        Assert.Empty(Find(picture, new PanelColours(Black, White)));
    }

    [Fact]
    public void Find_HoleInIt_IsPartOfIt()
    {
        byte[] picture = Ground();
        Fill(picture, 40, 30, 14, 14, Black);
        Fill(picture, 44, 34, 6, 6, new ColourRange(110, 112, 108));
        PanelShape panel = Assert.Single(Find(picture, new PanelColours(Black)));
        Assert.Equal(196, panel.OutlinePixels);
        Assert.Equal((196 - 36) / 196.0, panel.FirstShare, 9);
    }

    [Fact]
    public void Find_PartOfSomethingLonger_IsNone()
    {
        byte[] picture = Ground();
        Fill(picture, 0, 30, Width, 12, Black);
        Assert.Empty(Find(picture, new PanelColours(Black)));
    }

    [Fact]
    public void Find_AtTheBorder_SaysSo()
    {
        byte[] picture = Ground();
        Fill(picture, 0, 30, 12, 12, Black);
        Assert.True(Assert.Single(Find(picture, new PanelColours(Black))).TouchesBorder);
    }

    [Fact]
    public void Find_MorePanelsThanThereIsRoomFor_CountsThem()
    {
        (int width, int height) = (12 * 60, 12 * 50);
        var picture = new RgbPicture(width, height, [.. Enumerable.Repeat((byte)110, width * height * 3)]);
        for (int i = 0; i < 3000; i++)
        {
            for (int pixel = 0; pixel < 16; pixel++)
            {
                int at = ((((i / 60 * 12) + 4 + (pixel / 4)) * width) + (i % 60 * 12) + 4 + (pixel % 4)) * 3;
                picture.Pixels[at] = picture.Pixels[at + 1] = picture.Pixels[at + 2] = 10;
            }
        }

        var limits = new PanelLimits { MinSide = 4, MaxSide = 5, UsualSide = 4 };
        Assert.Equal(
            PanelFinder.MaxPanels,
            _finder.Find(picture.Pixels, width, height, new PanelColours(Black), limits).Length);
        Assert.Equal(3000 - PanelFinder.MaxPanels, _finder.Dropped);
    }

    [Fact]
    public void Find_PictureAfterPicture_AllocatesNothing()
    {
        byte[] picture = Ground();
        Fill(picture, 40, 30, 12, 6, Black);
        Fill(picture, 40, 36, 12, 6, White);
        var colours = new PanelColours(Black, White);
        void Work() => _finder.Find(picture, Width, Height, colours, Limits);
        Work();
        Assert.Equal(0, Allocated.By(Work));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void Close_RandomMasks_IsThatOfTheDefinition(int reach)
    {
        const int seed = 11;
        var random = new Random(seed);
        var mask = new PixelMask();
        for (int i = 0; i < 20; i++)
        {
            (int width, int height) = (random.Next(1, 40), random.Next(1, 30));
            mask.Resize(width, height);
            var ones = new bool[width, height];
            for (int at = 0; at < width * height; at++)
            {
                ones[at % width, at / width] = random.Next(4) == 0;
                mask.Bytes[mask.At(at % width, at / width)] = (byte)(ones[at % width, at / width] ? 1 : 0);
            }

            mask.Close(reach);
            bool[,] expected = Grow(Grow(ones, reach, isGrowing: true), reach, isGrowing: false);
            for (int at = 0; at < width * height; at++)
            {
                bool isOne = mask.Bytes[mask.At(at % width, at / width)] == 1;
                Assert.True(
                    expected[at % width, at / width] == isOne,
                    $"seed {seed}, mask {i}: {at % width}, {at / width} of {width} x {height}");
            }
        }
    }

    [Theory]
    [InlineData(0.2)]
    [InlineData(1.3)]
    [InlineData(2.4)]
    public void FittedRectangle_OfCorners_IsThatRectangle(double angle)
    {
        (double cos, double sin) = (Math.Cos(angle), Math.Sin(angle));
        PicturePoint[] corners = new (double U, double V)[] { (6, 2), (6, -2), (-6, 2), (-6, -2) }
            .Select(c => new PicturePoint(3 + (c.U * cos) - (c.V * sin), (c.U * sin) + (c.V * cos))).ToArray();
        FittedRectangle fitted = FittedRectangle.Of(corners, 0.5);
        Assert.Equal(12.5, fitted.Length, 0.1);
        Assert.Equal(4.5, fitted.Width, 0.1);
        Assert.Equal(angle, fitted.AngleRadians, 0.01);
    }

    [Fact]
    public void PanelColours_TooNearOrGrey_AreRefused()
    {
        Assert.True(PanelColours.IsBlack(Black) && PanelColours.IsWhite(White));
        Assert.False(PanelColours.IsBlack(Red) || PanelColours.IsWhite(Red));
        Assert.Null(PanelColours.FindFault(Red, new ColourRange(28, 72, 205)));
        Assert.Contains(
            "grey", Assert.Throws<ArgumentException>(() => new PanelColours(new ColourRange(120, 120, 120))).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "too near", Assert.Throws<ArgumentException>(() => new PanelColours(Red, new ColourRange(212, 36, 60)))
                .Message,
            StringComparison.Ordinal);
    }

    private static byte[] Ground() => [.. Enumerable.Range(0, Width * Height * 3).Select(i => (byte)(105 + (i % 7)))];

    private static void Fill(byte[] picture, int left, int top, int columns, int rows, ColourRange colour)
    {
        for (int at = 0; at < columns * rows; at++)
        {
            int pixel = (((top + (at / columns)) * Width) + left + (at % columns)) * 3;
            (picture[pixel], picture[pixel + 1], picture[pixel + 2]) = (colour.Red, colour.Green, colour.Blue);
        }
    }

    private static bool[,] Grow(bool[,] ones, int reach, bool isGrowing)
    {
        (int width, int height) = (ones.GetLength(0), ones.GetLength(1));
        var grown = new bool[width, height];
        for (int at = 0; at < width * height; at++)
        {
            (int column, int row) = (at % width, at / width);
            bool any = false;
            for (int y = Math.Max(0, row - reach); y <= Math.Min(height - 1, row + reach); y++)
            {
                for (int x = Math.Max(0, column - reach); x <= Math.Min(width - 1, column + reach); x++)
                    any |= ones[x, y] == isGrowing;
            }

            grown[column, row] = any == isGrowing;
        }

        return grown;
    }

    private PanelShape[] Find(byte[] picture, PanelColours colours)
        => _finder.Find(picture, Width, Height, colours, Limits).ToArray();
}
