using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Reporting.Exports;
using Xunit;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>Outlines of filled cells.</summary>
public sealed class CellGridTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Patches_RandomCells_HaveTheAreaOfTheCellsAndPassNoCornerTwice(int seed)
    {
        var random = new Random(seed);
        var grid = new CellGrid(30, 20);
        var filled = new HashSet<(int X, int Y)>();
        for (int count = 0; count < 330; count++)
        {
            (int x, int y) = (random.Next(30), random.Next(20));
            filled.Add((x, y));
            grid.Fill([(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]);
        }

        double area = 0;
        foreach ((IReadOnlyList<(int X, int Y)> outline, IReadOnlyList<IReadOnlyList<(int X, int Y)>> holes)
            in grid.Patches())
        {
            Assert.True(Area(outline) > 0);
            Assert.All(holes, h => Assert.True(Area(h) < 0));
            Assert.All(holes.Append(outline), l => Assert.Equal(l.Count, l.Distinct().Count()));
            area += Area(outline) + holes.Sum(Area);
        }

        Assert.Equal(filled.Count, area);
    }

    private static double Area(IReadOnlyList<(int X, int Y)> loop)
        => Enumerable.Range(0, loop.Count).Sum(i =>
        {
            ((int x1, int y1), (int x2, int y2)) = (loop[i], loop[(i + 1) % loop.Count]);
            return ((x1 * y2) - (x2 * y1)) / 2.0;
        });
}
