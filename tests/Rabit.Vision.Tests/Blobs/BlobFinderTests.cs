using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;

namespace Rabit.Vision.Tests.Blobs;

public sealed class BlobFinderTests
{
    private static readonly (byte Red, byte Green, byte Blue)[] Colours =
        [(205, 28, 32), (242, 112, 18), (28, 72, 205), (243, 214, 28), (212, 36, 150)];

    [Fact]
    public void TryFind_RandomPictures_BlobsAreThoseOfAFloodFill()
    {
        const int Seed = 77;
        var random = new Random(Seed);
        ColourTable table = Table();
        var finder = new BlobFinder();
        for (int n = 0; n < 200; n++)
        {
            (int width, int height) = (1 + random.Next(24), 1 + random.Next(24));
            int[] classes = Enumerable.Range(0, width * height)
                .Select(_ => Math.Max(0, random.Next(n % 5 + 2) - 1)).ToArray();
            Assert.True(finder.TryFind(Paint(classes), width, height, table));
            IEnumerable<string> found = finder.Blobs.ToArray()
                .Select(b => $"{b.Class}: {b.Left}-{b.Right} {b.Top}-{b.Bottom} {b.Pixels}");
            Assert.Equal(
                Flooded(classes, width, height).OrderBy(s => s, StringComparer.Ordinal),
                found.OrderBy(s => s, StringComparer.Ordinal));
        }
    }

    [Fact]
    public void TryFind_BufferTooSmall_IsRefused()
        => Assert.Throws<ArgumentException>(() => new BlobFinder().TryFind(new byte[11], 2, 2, Table()));

    [Fact]
    public void TryMeasure_SquareWithHalfCoveredEdge_HasItsAreaAndCentre()
    {
        // 6 x 6 red pixels, and a column to the right of them that is half red, half grass.
        const int Side = 20;
        var picture = new byte[Side * Side * 3];
        for (int at = 0; at < Side * Side; at++)
        {
            (int x, int y) = (at % Side, at / Side);
            double red = y is < 7 or > 12 || x is < 7 or > 13 ? 0 : x == 13 ? 0.5 : 1;
            picture[3 * at] = (byte)(86 + (red * (205 - 86)));
            picture[(3 * at) + 1] = (byte)(112 + (red * (28 - 112)));
            picture[(3 * at) + 2] = (byte)(56 + (red * (32 - 56)));
        }

        ColourTable table = Table();
        var finder = new BlobFinder();
        var measure = new BlobMeasure();
        Assert.True(finder.TryFind(picture, Side, Side, table));
        measure.SetPicture(picture, Side, Side, table);
        Blob blob = Assert.Single(finder.Blobs.ToArray());
        Assert.False(measure.TouchesBorder(blob));
        Assert.True(measure.TryMeasure(blob, out BlobShape shape));
        Assert.Equal(39, shape.Area, 0.3);
        Assert.Equal(((36 * 9.5) + (3 * 13)) / 39, shape.CentreX, 0.02);
        Assert.Equal(9.5, shape.CentreY, 0.01);
    }

    private static ColourTable Table()
    {
        var table = new ColourTable(Colours.Select(c => new ColourRange(c.Red, c.Green, c.Blue)).ToArray());
        table.Select(0b11111);
        return table;
    }

    private static byte[] Paint(int[] classes) => classes.SelectMany(c =>
    {
        (byte r, byte g, byte b) = c == 0 ? ((byte)86, (byte)112, (byte)56) : Colours[c - 1];
        return new[] { r, g, b };
    }).ToArray();

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

            blobs.Add($"{colour}: {members.Min(m => m % width)}-{members.Max(m => m % width)} "
                + $"{members.Min(m => m / width)}-{members.Max(m => m / width)} {members.Count}");
        }

        return blobs;
    }
}
