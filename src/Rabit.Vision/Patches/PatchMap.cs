using System;

namespace Rabit.Vision;

/// <summary>
/// The box around a patch with a margin: which pixels are its own, or lie between such, which may be covered in part,
/// and which are the ground around it. A step to a neighbour at a corner is one step too.
/// </summary>
internal sealed class PatchMap
{
    // Up to that distance a pixel may be covered in part, and up to that one it is the ground around.
    private const int EdgeReach = 2;
    private const int GroundReach = 4;

    private readonly BitGrid _all = new();
    private readonly BitGrid _nearInRow = new();
    private readonly BitGrid _farInRow = new();
    private int _width;
    private int _height;

    /// <summary>The pixels of the patch.</summary>
    public BitGrid Own { get; } = new();

    /// <summary>What lies between them, as the windows of a car (<see cref="PatchGaps"/>).</summary>
    public BitGrid Closed { get; } = new();

    /// <summary>Both, and what of the picture is so near that a part of it may be covered.</summary>
    public BitGrid Edge { get; } = new();

    /// <summary>What of the picture comes after that.</summary>
    public BitGrid Ground { get; } = new();

    /// <summary>The column of the picture of the first column.</summary>
    public int Left { get; private set; }

    /// <summary>The row of the picture of the first row.</summary>
    public int Top { get; private set; }

    public int Columns { get; private set; }

    public int Rows { get; private set; }

    public void SetPicture(int width, int height) => (_width, _height) = (width, height);

    /// <param name="parts">At least one.</param>
    /// <param name="finder">What found them.</param>
    /// <param name="closesGaps">Whether what lies between their pixels belongs to them.</param>
    public void Draw(ReadOnlySpan<Patch> parts, PatchFinder finder, bool closesGaps)
    {
        (int left, int top, int right, int bottom) = (int.MaxValue, int.MaxValue, 0, 0);
        foreach (ref readonly Patch part in parts)
        {
            (left, top) = (Math.Min(left, part.Left), Math.Min(top, part.Top));
            (right, bottom) = (Math.Max(right, part.Right), Math.Max(bottom, part.Bottom));
        }

        (Left, Top) = (left - GroundReach, top - GroundReach);
        (Columns, Rows) = (right + GroundReach + 1 - Left, bottom + GroundReach + 1 - Top);
        Own.Clear(Columns, Rows);
        foreach (ref readonly Patch part in parts)
            finder.Draw(part, Own, Left, Top);
        Closed.Clear(Columns, Rows);
        Reach(closesGaps && PatchGaps.TryClose(Own, Closed, Columns, GroundReach) ? Union() : Own);
        LeaveOutside(right, bottom);
    }

    /// <summary>Those of its pixels that have only such beside, above and below.</summary>
    public ulong InnerOf(int row, int word)
        => Own[row, word] & Own.Beside(row, word, -1) & Own.Beside(row, word, 1)
            & Own[row - 1, word] & Own[row + 1, word];

    /// <summary>
    /// Those of the inner ones that are so far from the edge that the blur of the lens, and of the colour in a JPEG,
    /// does not reach them.
    /// </summary>
    public ulong CoreOf(int row, int word, ulong inner)
        => inner & Own.Beside(row, word, -2) & Own.Beside(row, word, 2) & Own[row - 2, word] & Own[row + 2, word]
            & Own.Beside(row - 1, word, -1) & Own.Beside(row - 1, word, 1)
            & Own.Beside(row + 1, word, -1) & Own.Beside(row + 1, word, 1);

    /// <summary>Where the pixel of a cell begins in the picture.</summary>
    public int PixelAt(int column, int row) => (((row + Top) * _width) + column + Left) * 3;

    /// <summary>Whether the pixel of a cell is at the border of the picture.</summary>
    public bool IsAtBorder(int column, int row)
        => column + Left == 0 || row + Top == 0 || column + Left == _width - 1 || row + Top == _height - 1;

    private BitGrid Union()
    {
        _all.Clear(Columns, Rows);
        for (int row = 0; row < Rows; row++)
        {
            for (int word = 0; word < _all.Words; word++)
                _all[row, word] = Own[row, word] | Closed[row, word];
        }

        return _all;
    }

    // What is so near in a column and in a row is so near at a corner too.
    private void Reach(BitGrid all)
    {
        ReachInRows(all);
        Edge.Clear(Columns, Rows);
        Ground.Clear(Columns, Rows);
        for (int row = 0; row < Rows; row++)
        {
            for (int word = 0; word < Edge.Words; word++)
            {
                ulong near = Within(_nearInRow, row, word, EdgeReach);
                Edge[row, word] = near;
                Ground[row, word] = Within(_farInRow, row, word, GroundReach) & ~near;
            }
        }
    }

    private void ReachInRows(BitGrid all)
    {
        _nearInRow.Clear(Columns, Rows);
        _farInRow.Clear(Columns, Rows);
        for (int row = GroundReach; row < Rows - GroundReach; row++)
        {
            for (int word = 0; word < all.Words; word++)
            {
                _nearInRow[row, word] = all[row, word] | all.Beside(row, word, 1) | all.Beside(row, word, -1)
                    | all.Beside(row, word, EdgeReach) | all.Beside(row, word, -EdgeReach);
            }

            for (int word = 0; word < all.Words; word++)
            {
                _farInRow[row, word] = _nearInRow[row, word]
                    | _nearInRow.Beside(row, word, EdgeReach) | _nearInRow.Beside(row, word, -EdgeReach);
            }
        }
    }

    private static ulong Within(BitGrid grid, int row, int word, int reach)
    {
        ulong bits = 0;
        for (int other = Math.Max(0, row - reach); other <= Math.Min(grid.Rows - 1, row + reach); other++)
            bits |= grid[other, word];
        return bits;
    }

    private void LeaveOutside(int right, int bottom)
    {
        if (Left >= 0 && Top >= 0 && right + GroundReach < _width && bottom + GroundReach < _height)
            return;
        Edge.KeepWithin(-Left, -Top, _width - 1 - Left, _height - 1 - Top);
        Ground.KeepWithin(-Left, -Top, _width - 1 - Left, _height - 1 - Top);
    }
}
