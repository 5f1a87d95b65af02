using System;

namespace UavConsole;

/// <summary>
/// A drawing of dots, two across and four down in each character; each character has the ink of what matters most in
/// it.
/// </summary>
internal sealed class BrailleCanvas(int columns, int rows)
{
    public const int DotsAcross = 2;
    public const int DotsDown = 4;

    // Unicode, "Braille Patterns" (U+2800): bit of each dot, by column and row.
    private const char Blank = '\u2800';
    private static readonly byte[] Bits = [0x01, 0x02, 0x04, 0x40, 0x08, 0x10, 0x20, 0x80];

    private readonly byte[] _dots = new byte[columns * rows];
    private readonly MapInk[] _inks = new MapInk[columns * rows];

    /// <summary>Sets a dot; one outside the drawing is nothing.</summary>
    public void Dot(int x, int y, MapInk ink)
    {
        if (x < 0 || y < 0 || x >= columns * DotsAcross || y >= rows * DotsDown)
            return;
        int cell = (y / DotsDown * columns) + (x / DotsAcross);
        _dots[cell] |= Bits[(x % DotsAcross * DotsDown) + (y % DotsDown)];
        if (ink > _inks[cell])
            _inks[cell] = ink;
    }

    /// <summary>A line of dots.</summary>
    /// <param name="x1">Dots from the left.</param>
    /// <param name="y1">Dots from the top.</param>
    /// <param name="x2">Dots from the left.</param>
    /// <param name="y2">Dots from the top.</param>
    /// <param name="ink">What it is.</param>
    /// <param name="every">Only every so many dots.</param>
    public void Line(double x1, double y1, double x2, double y2, MapInk ink, int every = 1)
    {
        // One of its ends may be far outside; then it is not worth the walk.
        double length = Math.Max(Math.Abs(x2 - x1), Math.Abs(y2 - y1));
        if (!(length < 10_000))
            return;
        int steps = (int)Math.Ceiling(length);
        for (int step = 0; step <= steps; step += every)
        {
            double part = steps == 0 ? 0 : step / (double)steps;
            Dot((int)Math.Round(x1 + ((x2 - x1) * part)), (int)Math.Round(y1 + ((y2 - y1) * part)), ink);
        }
    }

    public MapInk InkAt(int column, int row) => _inks[(row * columns) + column];

    /// <param name="column">From the left.</param>
    /// <param name="row">From the top.</param>
    /// <param name="isUnicode">Without it plain characters stand for the dots.</param>
    public char CharacterAt(int column, int row, bool isUnicode)
    {
        int cell = (row * columns) + column;
        if (_dots[cell] == 0)
            return ' ';
        if (isUnicode)
            return (char)(Blank + _dots[cell]);
        return _inks[cell] switch
        {
            MapInk.Area => '#',
            MapInk.Path => '+',
            MapInk.Ellipse => 'o',
            _ => '.',
        };
    }
}
