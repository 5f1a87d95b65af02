using System;

namespace Rabit.Vision;

/// <summary>
/// Measures what may be a panel: its outline, what is within it and around it, and its centroid below the size of a
/// pixel. Memory that is used again; one thread.
/// </summary>
internal sealed class PanelMeasure
{
    /// <summary>In the mask: of the part that is measured.</summary>
    public const byte Taken = 2;

    /// <summary>In the mask: of one that was seen before.</summary>
    public const byte Left = 3;

    // The ring around it, by its side.
    private const double RingShare = 0.12;
    private const int MinRing = 2;

    // A pixel is a square, and counts as its centre.
    private const double PixelVariance = 1.0 / 12;

    // Of a cell of the window.
    private const byte Own = 1;
    private const byte Outside = 2;
    private const byte Inside = 3;

    private readonly RingReach _reach = new();
    private readonly PanelEdge _edge = new();
    private PicturePoint[] _points = new PicturePoint[1024];
    private byte[] _cells = [];
    private int[] _flood = [];
    private byte[] _pixels = [];
    private PixelMask _parts = new();
    private PixelMask _mask = new();
    private int _width;
    private int _height;
    private int _pointCount;   // of the outlines that are kept
    private PanelShape _measured;
    private bool _measuresForm;

    // The window around the part: its first column and row, its size.
    private int _left;
    private int _top;
    private int _columns;
    private int _rows;

    /// <summary>Begins with a picture.</summary>
    public void Begin(byte[] pixels, int width, int height, PixelMask parts, PixelMask mask, bool measuresForm)
    {
        (_pixels, _width, _height, _parts, _mask) = (pixels, width, height, parts, mask);
        _measuresForm = measuresForm;
        _pointCount = 0;
    }

    /// <summary>The outline of one.</summary>
    public ReadOnlySpan<PicturePoint> Outline(in PanelShape panel) => _points.AsSpan(panel.FirstPoint, panel.Points);

    /// <summary>What was measured last.</summary>
    public ref readonly PanelShape Measured => ref _measured;

    /// <summary>Keeps the outline of what was measured last.</summary>
    public void KeepOutline() => _pointCount += _measured.Points;

    /// <summary>Measures one.</summary>
    /// <param name="shape">With its box.</param>
    /// <param name="places">Its pixels, in the mask.</param>
    /// <param name="length">How many.</param>
    public ref readonly PanelShape Measure(PanelShape shape, int[] places, int length)
    {
        int margin = (2 * RingOf(Math.Max(shape.Width, shape.Height))) + 2;
        (_left, _top) = (shape.Left - margin, shape.Top - margin);
        (_columns, _rows) = (shape.Width + (2 * margin), shape.Height + (2 * margin));
        if (_cells.Length < _columns * _rows)
            (_cells, _flood) = (new byte[_columns * _rows], new int[_columns * _rows]);
        Array.Clear(_cells, 0, _columns * _rows);
        for (int i = 0; i < length; i++)
        {
            (int column, int row) = _mask.PixelAt(places[i]);
            _cells[((row - _top) * _columns) + column - _left] = Own;
        }

        FloodOutside();
        TakeOutline(ref shape);
        shape.TouchesBorder = shape.Left == 0 || shape.Top == 0
            || shape.Left + shape.Width == _width || shape.Top + shape.Height == _height;
        _reach.Measure(_cells, Inside, _columns, _rows, RingOf(Math.Sqrt(shape.OutlinePixels)));
        CountParts(ref shape);
        CountRing(ref shape);
        if (_measuresForm)
            MeasureForm(ref shape);
        _edge.FindCentre(ref shape, _pixels, _width, _height, _left, _top, _columns, _rows);
        for (int i = 0; i < length; i++)
            _mask.Bytes[places[i]] = Left;
        _measured = shape;
        return ref _measured;
    }

    private static int RingOf(double side) => Math.Max(MinRing, (int)Math.Round(RingShare * side));

    // What cannot be reached from outside is within it, also holes.
    private void FloodOutside()
    {
        int length = 0;
        Flood(0, ref length);
        for (int i = 0; i < length; i++)
        {
            int at = _flood[i];
            int column = at % _columns;
            if (column > 0)
                Flood(at - 1, ref length);
            if (column < _columns - 1)
                Flood(at + 1, ref length);
            if (at >= _columns)
                Flood(at - _columns, ref length);
            if (at < _columns * (_rows - 1))
                Flood(at + _columns, ref length);
        }
    }

    private void Flood(int at, ref int length)
    {
        if (_cells[at] != 0)
            return;
        _cells[at] = Outside;
        _flood[length++] = at;
    }

    private void TakeOutline(ref PanelShape shape)
    {
        (shape.FirstPoint, shape.Points) = (_pointCount, 0);
        for (int row = shape.Top - _top; row < shape.Top - _top + shape.Height; row++)
        {
            (int first, int last) = (-1, -1);
            for (int column = 0; column < _columns; column++)
            {
                ref byte cell = ref _cells[(row * _columns) + column];
                if (cell == Outside)
                    continue;
                cell = Inside;
                shape.OutlinePixels++;
                first = first < 0 ? column : first;
                last = column;
            }

            AddPoint(ref shape, first + _left, row + _top);
            AddPoint(ref shape, last + _left, row + _top);
        }
    }

    private void AddPoint(ref PanelShape shape, int column, int row)
    {
        int place = shape.FirstPoint + shape.Points++;
        if (place == _points.Length)
            Array.Resize(ref _points, 2 * place);
        _points[place] = new PicturePoint(column, row);
    }

    // Of whole pixels, about their own centre.
    private void MeasureForm(ref PanelShape shape)
    {
        (double sumX, double sumY) = (0, 0);
        for (int at = 0; at < _columns * _rows; at++)
        {
            if (_cells[at] == Inside)
                (sumX, sumY) = (sumX + (at % _columns), sumY + (at / _columns));
        }

        (sumX, sumY) = (sumX / shape.OutlinePixels, sumY / shape.OutlinePixels);
        FormSums sums = default;
        for (int at = 0; at < _columns * _rows; at++)
        {
            if (_cells[at] == Inside)
                sums.Add((at % _columns) - sumX, (at / _columns) - sumY, 1);
        }

        shape.Form = sums.MomentsWithout(-PixelVariance);
    }

    private void CountParts(ref PanelShape shape)
    {
        (int first, int second) = (0, 0);
        _edge.Begin(_reach);
        for (int row = shape.Top; row < shape.Top + shape.Height; row++)
        {
            for (int column = shape.Left; column < shape.Left + shape.Width; column++)
            {
                if (_cells[((row - _top) * _columns) + column - _left] != Inside)
                    continue;
                int at = _parts.At(column, row);
                byte part = _parts.Bytes[at];
                first += part == 1 ? 1 : 0;
                second += part == 2 ? 1 : 0;
                if (part == 0)
                    continue;

                // The blur of the lens mixes what is beside another colour.
                bool isCore = _parts.Bytes[at - 1] == part && _parts.Bytes[at + 1] == part
                    && _parts.Bytes[at - _parts.Stride] == part && _parts.Bytes[at + _parts.Stride] == part;
                _edge.AddPart(part, isCore, _pixels, ((row * _width) + column) * 3);
            }
        }

        shape.FirstShare = first / (double)shape.OutlinePixels;
        shape.SecondShare = second / (double)shape.OutlinePixels;
    }

    private void CountRing(ref PanelShape shape)
    {
        (int covered, int all) = (0, 0);
        for (int row = Math.Max(0, _top); row < Math.Min(_height, _top + _rows); row++)
        {
            for (int column = Math.Max(0, _left); column < Math.Min(_width, _left + _columns); column++)
            {
                if (_reach.Of(((row - _top) * _columns) + column - _left) != RingReach.Ring)
                    continue;
                all++;
                if (_mask.Bytes[_mask.At(column, row)] != 0)
                    covered++;
                else
                    _edge.AddGround(_pixels, ((row * _width) + column) * 3);
            }
        }

        shape.CoveredRing = all == 0 ? 1 : covered / (double)all;
    }
}
