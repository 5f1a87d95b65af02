using System;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Geodesy.Tests;

/// <summary>What is above a block is above each of its posts: a ray never passes through a hill.</summary>
public sealed class TerrainPyramidTests
{
    private const int Rows = 70;
    private const int Columns = 53;

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void FindBlock_RandomGrid_IsTheLargestThatTheAltitudeIsAbove(int seed)
    {
        var random = new SeededNumbers(1000 * seed);
        var altitudes = new float[Rows * Columns];
        for (int post = 0; post < altitudes.Length; post++)
            altitudes[post] = (float)random.Uniform(0, 100);
        var pyramid = new TerrainPyramid(altitudes, Rows, Columns, highest: 100);
        for (int sample = 0; sample < 2000; sample++)
        {
            int row = random.Below(Rows - 1);
            int column = random.Below(Columns - 1);
            double altitude = random.Uniform(80, 110);

            int side = pyramid.FindBlock(row, column, altitude, out _);

            string where = FormattableString.Invariant($"seed {seed}, {altitude} m at {row}, {column}: {side}");
            Assert.True(side == 1 || altitude > MaxOf(altitudes, row, column, side, around: 0), where);
            Assert.True(
                side > 1
                    || altitude <= MaxOf(altitudes, row, column, TerrainPyramid.BlockCells, around: 1), where);
        }
    }

    // Of the posts of the cells of a block, and of some around them.
    private static double MaxOf(float[] altitudes, int row, int column, int side, int around)
    {
        double highest = double.NegativeInfinity;
        (int south, int west) = (row / side * side, column / side * side);
        for (int r = Math.Max(0, south - around); r <= Math.Min(Rows - 1, south + side + around); r++)
        {
            for (int c = Math.Max(0, west - around); c <= Math.Min(Columns - 1, west + side + around); c++)
                highest = Math.Max(highest, altitudes[(r * Columns) + c]);
        }

        return highest;
    }
}
