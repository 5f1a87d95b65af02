using System;
using System.Collections.Generic;

namespace Rabit.Geodesy;

/// <summary>
/// The highest posts of square blocks of a grid, of 8 x 8 cells, 16 x 16 and so on up to the whole (a maximum
/// pyramid): what is above a block need not look at its posts. Each block has the posts around it too, so that a path
/// which is only nearly straight does not miss one. Immutable.
/// </summary>
internal sealed class TerrainPyramid
{
    /// <summary>Cells along a side of the smallest blocks: 64 cells for one number more.</summary>
    public const int BlockCells = 8;

    private readonly List<Level> _levels = [];

    public TerrainPyramid(float[] altitudes, int rows, int columns, float highest)
    {
        var level = new Level(Blocks(rows - 1, BlockCells), Blocks(columns - 1, BlockCells));
        for (int row = 0; row < level.Rows; row++)
        {
            for (int column = 0; column < level.Columns; column++)
                level[row, column] = MaxOf(altitudes, rows, columns, highest, row, column);
        }

        _levels.Add(level);
        while (level.Rows > 1 || level.Columns > 1)
        {
            level = Halved(level);
            _levels.Add(level);
        }
    }

    /// <summary>The side, in cells, of the largest block around a cell that an altitude is above; or 1.</summary>
    public int FindBlock(int row, int column, double altitude, out float highest)
    {
        for (int i = _levels.Count - 1; i >= 0; i--)
        {
            int side = BlockCells << i;
            highest = _levels[i][row / side, column / side];
            if (altitude > highest)
                return side;
        }

        highest = float.NaN;
        return 1;
    }

    private static int Blocks(int cells, int side) => (cells + side - 1) / side;

    private static float MaxOf(
        float[] altitudes, int rows, int columns, float highest, int blockRow, int blockColumn)
    {
        float most = float.NegativeInfinity;
        int south = Math.Max(0, (blockRow * BlockCells) - 1);
        int north = Math.Min(rows - 1, ((blockRow + 1) * BlockCells) + 1);
        int west = Math.Max(0, (blockColumn * BlockCells) - 1);
        int east = Math.Min(columns - 1, ((blockColumn + 1) * BlockCells) + 1);
        for (int row = south; row <= north; row++)
        {
            for (int column = west; column <= east; column++)
            {
                float altitude = altitudes[(row * columns) + column];

                // What has no altitude may be as high as anything.
                if (float.IsNaN(altitude))
                    return highest;
                most = Math.Max(most, altitude);
            }
        }

        return most;
    }

    private static Level Halved(Level fine)
    {
        var coarse = new Level((fine.Rows + 1) / 2, (fine.Columns + 1) / 2);
        for (int row = 0; row < coarse.Rows; row++)
        {
            for (int column = 0; column < coarse.Columns; column++)
            {
                int north = Math.Min((2 * row) + 1, fine.Rows - 1);
                int east = Math.Min((2 * column) + 1, fine.Columns - 1);
                coarse[row, column] = Math.Max(
                    Math.Max(fine[2 * row, 2 * column], fine[2 * row, east]),
                    Math.Max(fine[north, 2 * column], fine[north, east]));
            }
        }

        return coarse;
    }

    private sealed class Level(int rows, int columns)
    {
        private readonly float[] _highest = new float[rows * columns];

        public int Rows { get; } = rows;

        public int Columns { get; } = columns;

        public float this[int row, int column]
        {
            get => _highest[(row * Columns) + column];
            set => _highest[(row * Columns) + column] = value;
        }
    }
}
