using System;

namespace Rabit.Vision;

/// <summary>
/// The box around a patch with a margin: for each pixel how far it is from the patch (<see cref="PatchDistances"/>).
/// Its edge may reach a little beyond it, and after that comes the ground around it.
/// </summary>
internal sealed class PatchMap
{
    /// <summary>Up to that distance a pixel may be covered in part.</summary>
    public const byte EdgeReach = 2;

    /// <summary>Up to that distance it is the ground around.</summary>
    public const byte GroundReach = 4;

    private int _width;
    private int _height;

    /// <summary>Distances, row by row.</summary>
    public byte[] Cells { get; private set; } = [];

    /// <summary>The column of the picture of the first column.</summary>
    public int Left { get; private set; }

    /// <summary>The row of the picture of the first row.</summary>
    public int Top { get; private set; }

    public int Columns { get; private set; }

    public int Rows { get; private set; }

    public void SetPicture(int width, int height) => (_width, _height) = (width, height);

    public void Draw(ReadOnlySpan<Patch> parts, PatchFinder finder)
    {
        (int left, int top, int right, int bottom) = (int.MaxValue, int.MaxValue, 0, 0);
        foreach (ref readonly Patch part in parts)
        {
            (left, top) = (Math.Min(left, part.Left), Math.Min(top, part.Top));
            (right, bottom) = (Math.Max(right, part.Right), Math.Max(bottom, part.Bottom));
        }

        (Left, Top) = (left - GroundReach, top - GroundReach);
        (Columns, Rows) = (right + GroundReach + 1 - Left, bottom + GroundReach + 1 - Top);
        if (Cells.Length < Columns * Rows)
            Cells = new byte[Columns * Rows];
        for (int at = 0; at < Columns * Rows; at++)
            Cells[at] = PatchDistances.Far;
        foreach (ref readonly Patch part in parts)
            finder.Draw(part, Cells, Left, Top, Columns, mark: 0);
        PatchDistances.Close(Cells, Columns, Rows, GroundReach);
        PatchDistances.Grow(Cells, Columns, Rows);
        LeaveOutside();
    }

    /// <summary>Whether a pixel of the patch has only such beside it.</summary>
    public bool IsInner(int at)
        => (Cells[at - 1] | Cells[at + 1] | Cells[at - Columns] | Cells[at + Columns]) == 0;

    /// <summary>
    /// Whether an inner one is so far from the edge that the blur of the lens, and of the colour in a JPEG, does not
    /// reach it.
    /// </summary>
    public bool IsCore(int at)
        => (Cells[at - 2] | Cells[at + 2] | Cells[at - (2 * Columns)] | Cells[at + (2 * Columns)]
            | Cells[at - Columns - 1] | Cells[at - Columns + 1] | Cells[at + Columns - 1] | Cells[at + Columns + 1])
            == 0;

    /// <summary>Where the pixel of a cell begins in the picture.</summary>
    public int PixelAt(int column, int row) => (((row + Top) * _width) + column + Left) * 3;

    /// <summary>Whether the pixel of a cell is at the border of the picture.</summary>
    public bool IsAtBorder(int column, int row)
        => column + Left == 0 || row + Top == 0 || column + Left == _width - 1 || row + Top == _height - 1;

    private void LeaveOutside()
    {
        for (int row = 0; row < Rows; row++)
        {
            bool isOutside = row + Top < 0 || row + Top >= _height;
            for (int column = 0; column < Columns; column++)
            {
                if (isOutside || column + Left < 0 || column + Left >= _width)
                    Cells[(row * Columns) + column] = PatchDistances.Far;
            }
        }
    }
}
