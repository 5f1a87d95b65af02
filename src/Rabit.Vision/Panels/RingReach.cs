namespace Rabit.Vision;

/// <summary>
/// Which cells of a window are within a part, beside it, and in the ring around it, by squares. Memory that is used
/// again.
/// </summary>
internal sealed class RingReach
{
    /// <summary>Of a cell: within, and all of its neighbours too.</summary>
    public const byte Deep = 4;

    /// <summary>Of a cell: within, at the edge.</summary>
    public const byte Edge = 3;

    /// <summary>Of a cell: outside, beside the edge.</summary>
    public const byte Beside = 2;

    /// <summary>Of a cell: in the ring.</summary>
    public const byte Ring = 1;

    private byte[] _reach = [];
    private int[] _across = [];

    /// <summary>What a cell is; 0 for none of them.</summary>
    public byte Of(int cell) => _reach[cell];

    /// <summary>Measures a window.</summary>
    /// <param name="cells">Its cells, row by row; those of its border are outside.</param>
    /// <param name="inside">What a cell within the part is.</param>
    /// <param name="columns">Of the window.</param>
    /// <param name="rows">Of the window.</param>
    /// <param name="ring">How far the ring goes.</param>
    public void Measure(byte[] cells, byte inside, int columns, int rows, int ring)
    {
        if (_reach.Length < columns * rows)
            (_reach, _across) = (new byte[columns * rows], new int[columns * rows]);
        for (int row = 0; row < rows; row++)
            MeasureAcross(cells, inside, row * columns, columns);
        for (int row = 0; row < rows; row++)
        {
            for (int column = 0; column < columns; column++)
            {
                int at = (row * columns) + column;
                _reach[at] = cells[at] == inside
                    ? IsDeep(cells, inside, at, columns) ? Deep : Edge
                    : Nearest(column, row, columns, rows, ring) switch
                    {
                        1 => Beside,
                        int steps => steps <= ring ? Ring : (byte)0,
                    };
            }
        }
    }

    private static bool IsDeep(byte[] cells, byte inside, int at, int columns)
    {
        for (int row = -columns; row <= columns; row += columns)
        {
            if (cells[at + row - 1] != inside || cells[at + row] != inside || cells[at + row + 1] != inside)
                return false;
        }

        return true;
    }

    // Steps to the nearest cell within, along the row.
    private void MeasureAcross(byte[] cells, byte inside, int first, int columns)
    {
        int steps = columns;
        for (int at = first; at < first + columns; at++)
            _across[at] = steps = cells[at] == inside ? 0 : steps + 1;
        steps = columns;
        for (int at = first + columns - 1; at >= first; at--)
        {
            steps = cells[at] == inside ? 0 : steps + 1;
            if (steps < _across[at])
                _across[at] = steps;
        }
    }

    // Steps in any of eight directions; more than the ring where there is none.
    private int Nearest(int column, int row, int columns, int rows, int ring)
    {
        int nearest = ring + 1;
        for (int down = -ring; down <= ring; down++)
        {
            if (row + down < 0 || row + down >= rows)
                continue;
            int steps = _across[((row + down) * columns) + column];
            int far = down < 0 ? -down : down;
            steps = steps > far ? steps : far;
            nearest = steps < nearest ? steps : nearest;
        }

        return nearest;
    }
}
