using System;
using System.Linq;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Vision.Tests.Patches;

/// <summary>The map of a patch, 64 pixels at a time, against what its definition says of each pixel.</summary>
public sealed class PatchMapTests(ITestOutputHelper output)
{
    private const int Width = 200;
    private const int Height = 90;
    private const int Margin = 4;

    private static readonly PatchTable Table = new([new ColourRange(205, 28, 32)]);

    private readonly PatchMap _map = new();

    /// <summary>Speckled things up to three words wide, some of them at the border.</summary>
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Draw_AnyPatch_IsWhatTheDefinitionSays(bool closesGaps)
    {
        int seed = Environment.TickCount;
        output.WriteLine($"seed {seed}");
        PatchFinder finder = Find(Paint(new Random(seed)));
        _map.SetPicture(Width, Height);
        Patch[] patches = finder.Patches.ToArray();
        Assert.Contains(patches, p => p.Right - p.Left > 64);
        foreach (Patch patch in patches)
        {
            _map.Draw([patch], finder, closesGaps);
            bool[,] own = Cells(_map.Own);
            Assert.Equal(patch.Pixels, own.Cast<bool>().Count(isOwn => isOwn));
            bool[,] closed = closesGaps ? Close(own) : new bool[own.GetLength(0), own.GetLength(1)];
            Assert.Equal(closed, Cells(_map.Closed));
            bool[,] near = Within(own, closed, 2);
            bool[,] far = Within(own, closed, 4);
            Assert.Equal(near, Cells(_map.Edge));
            for (int row = 0; row < _map.Rows; row++)
            {
                for (int column = 0; column < _map.Columns; column++)
                    far[row, column] &= !near[row, column];
            }

            Assert.Equal(far, Cells(_map.Ground));
        }
    }

    private static byte[] Paint(Random random)
    {
        byte[] picture = new byte[3 * Width * Height];
        Fill(picture, 86, 112, 70, _ => true);
        for (int thing = 0; thing < 5; thing++)
        {
            (int left, int top) = (random.Next(-10, Width), random.Next(-10, Height));
            (int right, int bottom) = (left + random.Next(3, 150), top + random.Next(3, 25));
            if (thing == 0)
                (left, top, right, bottom) = (10, 20, 160, 45);   // more than two words wide
            Fill(picture, 205, 28, 32, at =>
                at % Width >= left && at % Width <= right && at / Width >= top && at / Width <= bottom
                && random.Next(10) < 5);
        }

        return picture;
    }

    private static void Fill(byte[] picture, byte red, byte green, byte blue, Func<int, bool> isPart)
    {
        for (int at = 0; at < Width * Height; at++)
        {
            if (isPart(at))
                (picture[3 * at], picture[(3 * at) + 1], picture[(3 * at) + 2]) = (red, green, blue);
        }
    }

    private static PatchFinder Find(byte[] picture)
    {
        var light = new PictureLight();
        var finder = new PatchFinder();
        light.Measure(picture, Width, Height);
        Assert.True(finder.TryFind(picture, Width, Height, Table, light));
        return finder;
    }

    private bool[,] Cells(BitGrid grid)
    {
        var cells = new bool[_map.Rows, _map.Columns];
        for (int row = 0; row < _map.Rows; row++)
        {
            for (int column = 0; column < _map.Columns; column++)
                cells[row, column] = ((grid[row, column >> 6] >> (column & 63)) & 1) != 0;
        }

        return cells;
    }

    private bool[,] Close(bool[,] own)
    {
        var closed = new bool[_map.Rows, _map.Columns];
        int gap = (int)(0.25 * Math.Sqrt(own.Cast<bool>().Count(isOwn => isOwn)));
        if (gap < 2)
            return closed;
        for (int row = 0; row < _map.Rows; row++)
        {
            for (int column = 0; column < _map.Columns; column++)
            {
                if (own[row, column])
                    continue;
                closed[row, column] =
                    Steps(own, row, column, 0, -1) + Steps(own, row, column, 0, 1) - 1 <= gap
                    || Steps(own, row, column, -1, 0) + Steps(own, row, column, 1, 0) - 1 <= gap;
            }
        }

        return closed;
    }

    // To the next pixel of the patch that way; very many if there is none.
    private int Steps(bool[,] own, int row, int column, int down, int right)
    {
        for (int steps = 1; ; steps++)
        {
            (int y, int x) = (row + (steps * down), column + (steps * right));
            if (y < 0 || x < 0 || y >= _map.Rows || x >= _map.Columns)
                return 1_000_000;
            if (own[y, x])
                return steps;
        }
    }

    private bool[,] Within(bool[,] own, bool[,] closed, int reach)
    {
        var cells = new bool[_map.Rows, _map.Columns];
        for (int row = Margin; row < _map.Rows - Margin; row++)
        {
            for (int column = Margin; column < _map.Columns - Margin; column++)
            {
                if (own[row, column] || closed[row, column])
                    Reach(cells, row, column, reach);
            }
        }

        return cells;
    }

    private void Reach(bool[,] cells, int row, int column, int reach)
    {
        for (int y = row - reach; y <= row + reach; y++)
        {
            for (int x = column - reach; x <= column + reach; x++)
            {
                bool isInPicture = x + _map.Left >= 0 && x + _map.Left < Width && y + _map.Top >= 0
                    && y + _map.Top < Height;
                cells[y, x] |= isInPicture;
            }
        }
    }
}
