using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What a rectangle on the ground looks like: cells side by side, each of a colour of a palette, or none, where the
/// ground is seen; and what hides a part of it. Immutable.
/// </summary>
internal sealed class SurfacePattern
{
    /// <summary>A cell through which the ground is seen.</summary>
    public const byte Open = byte.MaxValue;

    // Of what hides a part, cells side by side.
    private const int CoverSide = 24;

    private readonly byte[] _cells;
    private readonly SurfaceColour[] _palette;
    private readonly bool[]? _isCovered;

    /// <param name="rows">From the end that its heading points to.</param>
    /// <param name="columns">From the left, seen from above.</param>
    /// <param name="cells">Places in the palette, row by row.</param>
    /// <param name="palette">The colours.</param>
    public SurfacePattern(int rows, int columns, byte[] cells, SurfaceColour[] palette)
        : this(rows, columns, cells, palette, isCovered: null)
    {
    }

    private SurfacePattern(int rows, int columns, byte[] cells, SurfaceColour[] palette, bool[]? isCovered)
    {
        if (cells.Length != rows * columns)
            throw new ArgumentException($"There are {cells.Length} cells, not {rows} x {columns}.", nameof(cells));
        (Rows, Columns, _cells, _palette, _isCovered) = (rows, columns, cells, palette, isCovered);
    }

    public int Rows { get; }

    public int Columns { get; }

    /// <summary>The first colour: what most of it is.</summary>
    public SurfaceColour Main => _palette[0];

    /// <summary>Of one colour.</summary>
    public static SurfacePattern Of(SurfaceColour colour) => new(1, 1, [0], [colour]);

    /// <summary>From lines of text, one digit for a colour each; a point is open.</summary>
    public static SurfacePattern Of(SurfaceColour[] palette, params string[] lines)
    {
        byte[] cells = new byte[lines.Length * lines[0].Length];
        for (int row = 0; row < lines.Length; row++)
        {
            for (int column = 0; column < lines[0].Length; column++)
            {
                char one = lines[row][column];
                cells[(row * lines[0].Length) + column] = one == '.' ? Open : (byte)(one - '0');
            }
        }

        return new SurfacePattern(lines.Length, lines[0].Length, cells, palette);
    }

    /// <summary>The colour at a place; false where the ground is seen.</summary>
    /// <param name="down">0 at the end that its heading points to, below 1 at the other one.</param>
    /// <param name="right">0 at the left side, below 1 at the right one.</param>
    /// <param name="colour">What is there.</param>
    public bool TryAt(double down, double right, out SurfaceColour colour)
    {
        colour = default;
        if (!(down >= 0 && down < 1 && right >= 0 && right < 1)
            || _isCovered?[((int)(down * CoverSide) * CoverSide) + (int)(right * CoverSide)] == true)
            return false;
        byte cell = _cells[((int)(down * Rows) * Columns) + (int)(right * Columns)];
        if (cell == Open)
            return false;
        colour = _palette[cell];
        return true;
    }

    /// <summary>The same a little lighter or darker, and each colour a little off.</summary>
    public SurfacePattern Vary(ref SeededSequence random)
    {
        var varied = new SurfaceColour[_palette.Length];
        double light = SurfaceColour.LightOf(ref random);
        for (int i = 0; i < varied.Length; i++)
            varied[i] = _palette[i].Vary(light, ref random);
        return new SurfacePattern(Rows, Columns, _cells, varied, _isCovered);
    }

    /// <summary>
    /// The same with a part overgrown: beyond a ragged line across it, a fifth to two fifths of it.
    /// </summary>
    public SurfacePattern PartlyHidden(ref SeededSequence random)
    {
        double angle = 2 * Math.PI * random.NextUnit();
        (double sin, double cos) = (Trig.Sin(angle), Trig.Cos(angle));
        double part = 0.2 + (0.2 * random.NextUnit());
        double[] reach = new double[CoverSide * CoverSide];
        for (int i = 0; i < reach.Length; i++)
        {
            (double x, double y) = (((i % CoverSide) + 0.5) / CoverSide, ((i / CoverSide) + 0.5) / CoverSide);
            reach[i] = ((x - 0.5) * cos) + ((y - 0.5) * sin) + (0.08 * random.NextSigned());
        }

        double[] sorted = (double[])reach.Clone();
        Array.Sort(sorted);
        double from = sorted[(int)((1 - part) * sorted.Length)];
        return new SurfacePattern(Rows, Columns, _cells, _palette, Array.ConvertAll(reach, r => r >= from));
    }
}
