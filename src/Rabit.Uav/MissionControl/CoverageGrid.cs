using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Coverage: which part of an area the camera has seen, in square cells; a cell counts by its centre.
/// </summary>
internal sealed class CoverageGrid
{
    private const double MinCellMetres = 1;
    private const double MaxCells = 250_000;

    private readonly double _south;
    private readonly double _west;
    private readonly int _rows;
    private readonly int _columns;
    private readonly bool[] _isArea;
    private readonly bool[] _isSeen;

    public CoverageGrid(PlanePolygon area, IReadOnlyList<PlanePolygon>? keepOuts = null)
    {
        double north = double.NegativeInfinity;
        double east = double.NegativeInfinity;
        (_south, _west) = (double.PositiveInfinity, double.PositiveInfinity);
        foreach (PlanePoint c in area.Corners)
        {
            (_south, north) = (Math.Min(_south, c.North), Math.Max(north, c.North));
            (_west, east) = (Math.Min(_west, c.East), Math.Max(east, c.East));
        }

        CellMetres = Math.Max(MinCellMetres, Math.Sqrt((north - _south) * (east - _west) / MaxCells));
        _rows = (int)Math.Ceiling((north - _south) / CellMetres);
        _columns = (int)Math.Ceiling((east - _west) / CellMetres);
        _isArea = new bool[_rows * _columns];
        _isSeen = new bool[_rows * _columns];
        for (int i = 0; i < _isArea.Length; i++)
        {
            PlanePoint centre = CentreOf(i);
            _isArea[i] = area.Contains(centre) && !(keepOuts ?? []).Any(k => k.Contains(centre));
            Cells += _isArea[i] ? 1 : 0;
        }
    }

    /// <summary>Side of a cell.</summary>
    public double CellMetres { get; }

    /// <summary>How many cells the area has.</summary>
    public int Cells { get; }

    /// <summary>How many of them have been seen.</summary>
    public int SeenCells { get; private set; }

    /// <summary>How much of the area has been seen, 0 to 1.</summary>
    public double Fraction => Cells == 0 ? 1 : (double)SeenCells / Cells;

    /// <summary>Whether a point belongs to the area and has not been seen.</summary>
    public bool IsUnseen(PlanePoint at)
    {
        int cell = CellAt(at);
        return cell >= 0 && _isArea[cell] && !_isSeen[cell];
    }

    /// <summary>Whether a strip was seen, by places of the area on it, one for each cell.</summary>
    /// <param name="middle">The strip's middle line.</param>
    /// <param name="halfWidthMetres">How far it extends to either side.</param>
    /// <param name="maxUnseenFraction">How much of it may be unseen.</param>
    public bool IsSeen(LaneSegment middle, double halfWidthMetres, double maxUnseenFraction)
    {
        // In cells, from the corner of the grid.
        PlanePoint along = (1 / middle.Length) * (middle.End - middle.Start);
        double startRow = (middle.Start.North - _south) / CellMetres;
        double startColumn = (middle.Start.East - _west) / CellMetres;
        int steps = (int)Math.Ceiling((middle.Length / CellMetres) - 0.5);
        int sideSteps = (int)Math.Ceiling((2 * halfWidthMetres / CellMetres) - 0.5);
        double firstSide = 0.5 - (halfWidthMetres / CellMetres);
        double maxUnseen = maxUnseenFraction * steps * sideSteps;   // more is too much, whatever is of the area
        (int places, int unseen) = (0, 0);
        for (int step = 0; step < steps && unseen <= maxUnseen; step++)
        {
            double row = startRow + ((step + 0.5) * along.North) - (firstSide * along.East);
            double column = startColumn + ((step + 0.5) * along.East) + (firstSide * along.North);
            for (int side = 0; side < sideSteps; side++)
            {
                int cell = CellAt(row - (side * along.East), column + (side * along.North));
                if (cell < 0 || !_isArea[cell])
                    continue;
                places++;
                unseen += _isSeen[cell] ? 0 : 1;
            }
        }

        return unseen <= maxUnseenFraction * places;
    }

    /// <summary>Centres of the cells that have not been seen.</summary>
    public IEnumerable<PlanePoint> Unseen()
    {
        for (int i = 0; i < _isArea.Length; i++)
        {
            if (_isArea[i] && !_isSeen[i])
                yield return CentreOf(i);
        }
    }

    /// <summary>Marks what a picture showed: a convex quadrangle, its corners in order. Allocates nothing.</summary>
    public void Mark(PlanePoint a, PlanePoint b, PlanePoint c, PlanePoint d)
    {
        double south = Math.Min(Math.Min(a.North, b.North), Math.Min(c.North, d.North));
        double north = Math.Max(Math.Max(a.North, b.North), Math.Max(c.North, d.North));
        int first = Math.Max(0, (int)Math.Ceiling(((south - _south) / CellMetres) - 0.5));
        int last = Math.Min(_rows - 1, (int)Math.Floor(((north - _south) / CellMetres) - 0.5));
        for (int row = first; row <= last; row++)
        {
            double line = _south + ((row + 0.5) * CellMetres);
            double from = double.PositiveInfinity;
            double to = double.NegativeInfinity;
            Widen(a, b, line, ref from, ref to);
            Widen(b, c, line, ref from, ref to);
            Widen(c, d, line, ref from, ref to);
            Widen(d, a, line, ref from, ref to);
            MarkRow(row, from, to);
        }
    }

    /// <summary>Marks what was seen on an earlier flight.</summary>
    /// <param name="cells">The cells, relative to the home of that flight.</param>
    /// <param name="home">Where that is now.</param>
    public void Mark(CoverageCells cells, PlanePoint home)
    {
        for (int i = 0; i < _isArea.Length; i++)
        {
            if (!_isArea[i] || _isSeen[i] || !cells.IsSeen(CentreOf(i) - home))
                continue;
            _isSeen[i] = true;
            SeenCells++;
        }
    }

    /// <summary>What was seen, to be stored.</summary>
    /// <param name="previous">
    /// Where it is of this grid its bytes are filled again, so that nothing is allocated.
    /// </param>
    public CoverageCells ToCells(CoverageCells previous)
    {
        bool isOfThis = previous.Rows == _rows && previous.Columns == _columns
            && previous.CellMetres.Equals(CellMetres);
        CoverageCells cells = isOfThis
            ? previous
            : new CoverageCells(
                new PlanePoint(_south, _west), CellMetres, _rows, _columns,
                new byte[CoverageCells.BytesFor(_rows, _columns)]);
        Array.Clear(cells.Seen, 0, cells.Seen.Length);
        for (int i = 0; i < _isSeen.Length; i++)
        {
            if (_isSeen[i])
                cells.Seen[i >> 3] |= (byte)(1 << (i & 7));
        }

        return cells;
    }

    private static void Widen(PlanePoint a, PlanePoint b, double line, ref double from, ref double to)
    {
        if (Math.Min(a.North, b.North) > line || Math.Max(a.North, b.North) < line || a.North.Equals(b.North))
            return;
        double east = a.East + ((b.East - a.East) * (line - a.North) / (b.North - a.North));
        (from, to) = (Math.Min(from, east), Math.Max(to, east));
    }

    private void MarkRow(int row, double from, double to)
    {
        if (!(from <= to))
            return;
        int first = (int)Math.Max(0, Math.Ceiling(((from - _west) / CellMetres) - 0.5));
        int last = (int)Math.Min(_columns - 1, Math.Floor(((to - _west) / CellMetres) - 0.5));
        for (int i = (row * _columns) + first; i <= (row * _columns) + last; i++)
        {
            if (!_isArea[i] || _isSeen[i])
                continue;
            _isSeen[i] = true;
            SeenCells++;
        }
    }

    // Below zero outside the grid.
    private int CellAt(PlanePoint at) => CellAt((at.North - _south) / CellMetres, (at.East - _west) / CellMetres);

    private int CellAt(double row, double column)
        => row >= 0 && row < _rows && column >= 0 && column < _columns ? ((int)row * _columns) + (int)column : -1;

    private PlanePoint CentreOf(int cell)
        => new(_south + (((cell / _columns) + 0.5) * CellMetres), _west + (((cell % _columns) + 0.5) * CellMetres));
}
