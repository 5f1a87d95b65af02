using System;

namespace Rabit.Vision;

/// <summary>
/// For each tile of 4 x 4 pixels the grey level that parts dark from light: between the darkest and the lightest pixel
/// of it and its eight neighbours. 0, so that nothing is darker, where those are too alike. Memory of the largest
/// picture; for one thread.
/// </summary>
/// <remarks>
/// Wang and Olson, "AprilTag 2: Efficient and robust fiducial detection", IROS 2016, section III.A.
/// </remarks>
internal sealed class LocalThreshold
{
    public const int TileSide = 4;

    // Of the way from the darkest to the lightest, in 256ths: light grows at its edges, so the middle would lie in it.
    private const int Share = 140;

    private byte[] _min = [];
    private byte[] _max = [];
    private byte[] _columnMin = [];
    private byte[] _columnMax = [];

    /// <summary>The levels, row of tiles by row of tiles.</summary>
    public byte[] Levels { get; private set; } = [];

    /// <summary>Tiles in a row of them; that of the right edge may be partly outside.</summary>
    public int Columns { get; private set; }

    /// <summary>Rows of tiles.</summary>
    public int Rows { get; private set; }

    /// <summary>Finds the levels of a picture.</summary>
    public void Compute(ReadOnlySpan<byte> grey, int width, int height, int minContrast)
    {
        Columns = (width + TileSide - 1) / TileSide;
        Rows = (height + TileSide - 1) / TileSide;
        Reserve(width);
        for (int row = 0; row < Rows; row++)
        {
            ReduceColumns(grey, width, Math.Min(TileSide, height - (row * TileSide)), row);
            int to = row * Columns;
            GreyRows.ReduceTiles(_columnMin, _columnMax, _min.AsSpan(to, Columns), _max.AsSpan(to, Columns));
        }

        for (int row = 0; row < Rows; row++)
            FindLevels(row, minContrast);
    }

    // Of the rows of one row of tiles the smallest and the largest pixel of each column.
    private void ReduceColumns(ReadOnlySpan<byte> grey, int width, int count, int row)
    {
        int start = row * TileSide * width;
        int padded = Columns * TileSide;
        grey.Slice(start, width).CopyTo(_columnMin);
        grey.Slice(start, width).CopyTo(_columnMax);
        for (int i = 1; i < count; i++)
        {
            ReadOnlySpan<byte> next = grey.Slice(start + (i * width), width);
            GreyRows.Min(_columnMin, next);
            GreyRows.Max(_columnMax, next);
        }

        _columnMin.AsSpan(width, padded - width).Fill(_columnMin[width - 1]);
        _columnMax.AsSpan(width, padded - width).Fill(_columnMax[width - 1]);
    }

    private void FindLevels(int row, int minContrast)
    {
        Span<byte> min = _columnMin.AsSpan(1, Columns);
        Span<byte> max = _columnMax.AsSpan(1, Columns);
        _min.AsSpan(row * Columns, Columns).CopyTo(min);
        _max.AsSpan(row * Columns, Columns).CopyTo(max);
        if (row > 0)
            Include(row - 1, min, max);
        if (row < Rows - 1)
            Include(row + 1, min, max);

        // The neighbours of the outermost tiles are themselves.
        (_columnMin[0], _columnMax[0]) = (min[0], max[0]);
        (_columnMin[Columns + 1], _columnMax[Columns + 1]) = (min[Columns - 1], max[Columns - 1]);
        GreyRows.Levels(_columnMin, _columnMax, Levels.AsSpan(row * Columns, Columns), minContrast, Share);
    }

    private void Include(int row, Span<byte> min, Span<byte> max)
    {
        GreyRows.Min(min, _min.AsSpan(row * Columns, Columns));
        GreyRows.Max(max, _max.AsSpan(row * Columns, Columns));
    }

    private void Reserve(int width)
    {
        int tiles = Columns * Rows;
        if (Levels.Length < tiles)
            (Levels, _min, _max) = (new byte[tiles], new byte[tiles], new byte[tiles]);
        int columns = Math.Max(Columns * TileSide, width) + 2;
        if (_columnMin.Length < columns)
            (_columnMin, _columnMax) = (new byte[columns], new byte[columns]);
    }
}
