using System;

namespace Rabit.Vision;

/// <summary>
/// Histograms of oriented gradients of a grey plane in square cells: for each cell the strength of the edges of nine
/// directions (light to dark is the same as dark to light), normalised by the four blocks of 2 x 2 cells that it is in,
/// and one sum for each of those (N. Dalal, B. Triggs, "Histograms of Oriented Gradients for Human Detection", CVPR
/// 2005; the 13 numbers of a cell: P. Felzenszwalb et al., "Object Detection with Discriminatively Trained Part-Based
/// Models", PAMI 32, 2010, section 6). Memory that is used again; one thread.
/// </summary>
internal sealed class HogFeatures
{
    /// <summary>Numbers for each cell.</summary>
    public const int Dimensions = Directions + Blocks;

    private const int Directions = 9;
    private const int Blocks = 4;
    private const float MaxShare = 0.25f;

    // So that all 13 have about the same spread (Felzenszwalb et al.).
    private const float DirectionFactor = 0.5f;
    private const float BlockFactor = 0.2357f;

    // The strength of edges of a cell, per pixel, below which it counts as flat: noise has no direction.
    private const float FlatStrength = 0.005f;

    private float[] _histogram = [];
    private float[] _energy = [];
    private float[] _values = [];

    public int Columns { get; private set; }

    public int Rows { get; private set; }

    /// <summary>The numbers: those of dimension d, row r begin at (d x <see cref="Rows"/> + r) x columns.</summary>
    public ReadOnlySpan<float> Values => new(_values, 0, Dimensions * Rows * Columns);

    /// <summary>Computes them.</summary>
    /// <param name="plane">Brightness, row by row.</param>
    /// <param name="width">Columns of the plane.</param>
    /// <param name="height">Rows of the plane.</param>
    /// <param name="cellPixels">Side of a cell; what is left over at the right and at the bottom is in none.</param>
    public void Compute(float[] plane, int width, int height, int cellPixels)
    {
        (Columns, Rows) = (width / cellPixels, height / cellPixels);
        int cells = Columns * Rows;
        // One more at each side takes what the last pixels give to cells that there are not.
        int padded = (Columns + 2) * (Rows + 2) * Directions;
        Grow(ref _histogram, padded);
        Grow(ref _energy, (Columns + 2) * (Rows + 2));
        Grow(ref _values, Dimensions * cells);
        Array.Clear(_histogram, 0, padded);
        for (int y = 1; y < Math.Min(height, Rows * cellPixels) - 1; y++)
            AddRow(plane, width, y, cellPixels);
        SumEnergy();
        float flat = FlatStrength * cellPixels * cellPixels;
        for (int row = 0; row < Rows; row++)
        {
            for (int column = 0; column < Columns; column++)
                Normalise(row, column, flat * flat);
        }
    }

    /// <summary>Writes the numbers of a window, cell after cell and row after row.</summary>
    public void CopyWindow(int row, int column, int rows, int columns, Span<float> to)
    {
        int at = 0;
        for (int r = row; r < row + rows; r++)
        {
            for (int c = column; c < column + columns; c++)
            {
                for (int d = 0; d < Dimensions; d++)
                    to[at++] = _values[(((d * Rows) + r) * Columns) + c];
            }
        }
    }

    private static void Grow(ref float[] array, int length)
    {
        if (array.Length < length)
            array = new float[length];
    }

    private void AddRow(float[] plane, int width, int y, int cellPixels)
    {
        float inverse = 1f / cellPixels;
        float cellY = ((y + 0.5f) * inverse) + 0.5f;
        int row = (int)cellY;
        float below = cellY - row;
        int stride = (Columns + 2) * Directions;
        int end = Math.Min(width, Columns * cellPixels) - 1;
        for (int x = 1; x < end; x++)
        {
            int at = (y * width) + x;
            float gx = plane[at + 1] - plane[at - 1];
            float gy = plane[at + width] - plane[at - width];
            float square = (gx * gx) + (gy * gy);
            if (square == 0)
                continue;
            float strength = (float)Math.Sqrt(square);
            float direction = DirectionOf(gx, gy);
            int first = (int)direction;
            float second = strength * (direction - first);
            float rest = strength - second;
            if (first >= Directions)
                first -= Directions;
            int next = first + 1 == Directions ? 0 : first + 1;
            float cellX = ((x + 0.5f) * inverse) + 0.5f;
            int column = (int)cellX;
            float right = cellX - column;
            int cell = (row * stride) + (column * Directions);
            Add(cell, (1 - right) * (1 - below), first, next, rest, second);
            Add(cell + Directions, right * (1 - below), first, next, rest, second);
            Add(cell + stride, (1 - right) * below, first, next, rest, second);
            Add(cell + stride + Directions, right * below, first, next, rest, second);
        }
    }

    private void Add(int cell, float share, int first, int next, float rest, float second)
    {
        _histogram[cell + first] += share * rest;
        _histogram[cell + next] += share * second;
    }

    // Of the line, 0 up to 9 for half a turn; atan by a polynomial, 0.005 rad at most off.
    private static float DirectionOf(float gx, float gy)
    {
        const float quarter = (float)(Math.PI / 2);
        if (gy < 0 || (gy == 0 && gx < 0))
            (gx, gy) = (-gx, -gy);
        float ax = Math.Abs(gx);
        float ratio = Math.Min(ax, gy) / Math.Max(ax, gy);
        float angle = ratio * (0.97239411f - (0.19194795f * ratio * ratio));
        if (gy > ax)
            angle = quarter - angle;
        if (gx < 0)
            angle = (2 * quarter) - angle;
        return angle * (Directions / (2 * quarter));
    }

    private void SumEnergy()
    {
        for (int cell = 0; cell < (Columns + 2) * (Rows + 2); cell++)
        {
            int row = cell / (Columns + 2);
            int column = cell % (Columns + 2);
            float sum = 0;
            // What went beyond the last cells is none of theirs.
            if (row > 0 && row <= Rows && column > 0 && column <= Columns)
            {
                for (int d = 0; d < Directions; d++)
                    sum += _histogram[(cell * Directions) + d] * _histogram[(cell * Directions) + d];
            }

            _energy[cell] = sum;
        }
    }

    private void Normalise(int row, int column, float flatSquare)
    {
        int stride = Columns + 2;
        int cell = ((row + 1) * stride) + column + 1;
        int cells = Rows * Columns;
        int to = (row * Columns) + column;
        float n0 = Factor(cell - stride - 1, stride, flatSquare);
        float n1 = Factor(cell - stride, stride, flatSquare);
        float n2 = Factor(cell - 1, stride, flatSquare);
        float n3 = Factor(cell, stride, flatSquare);
        (float s0, float s1, float s2, float s3) = (0, 0, 0, 0);
        for (int d = 0; d < Directions; d++)
        {
            float h = _histogram[(cell * Directions) + d];
            float h0 = Math.Min(h * n0, MaxShare);
            float h1 = Math.Min(h * n1, MaxShare);
            float h2 = Math.Min(h * n2, MaxShare);
            float h3 = Math.Min(h * n3, MaxShare);
            _values[(d * cells) + to] = DirectionFactor * (h0 + h1 + h2 + h3);
            (s0, s1, s2, s3) = (s0 + h0, s1 + h1, s2 + h2, s3 + h3);
        }

        _values[(Directions * cells) + to] = BlockFactor * s0;
        _values[((Directions + 1) * cells) + to] = BlockFactor * s1;
        _values[((Directions + 2) * cells) + to] = BlockFactor * s2;
        _values[((Directions + 3) * cells) + to] = BlockFactor * s3;
    }

    // By the energy of the block whose top left cell it is.
    private float Factor(int cell, int stride, float flatSquare)
        => (float)(1 / Math.Sqrt(
            _energy[cell] + _energy[cell + 1] + _energy[cell + stride] + _energy[cell + stride + 1] + flatSquare));
}
