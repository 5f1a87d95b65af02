using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.Reporting.Exports;

/// <summary>Cells that are filled or not, and the outlines of those that are. X to the east, Y to the north.</summary>
internal sealed class CellGrid(int columns, int rows)
{
    private readonly bool[] _isFilled = new bool[columns * rows];
    private readonly int[] _patch = new int[columns * rows];   // 0 before the search for patches

    /// <summary>Whether a cell is filled.</summary>
    public bool IsFilled(int x, int y) => _isFilled[(y * columns) + x];

    /// <summary>Fills the cells whose middle is inside a figure; it must be convex.</summary>
    public void Fill((double X, double Y)[] corners)
    {
        int last = Math.Min(rows - 1, (int)Math.Floor(corners.Max(c => c.Y)));
        for (int row = Math.Max(0, (int)Math.Floor(corners.Min(c => c.Y))); row <= last; row++)
        {
            (double left, double right) = Span(corners, row + 0.5);
            int end = Math.Min(columns - 1, (int)Math.Floor(right - 0.5));
            for (int column = Math.Max(0, (int)Math.Ceiling(left - 0.5)); column <= end; column++)
                _isFilled[(row * columns) + column] = true;
        }
    }

    /// <summary>
    /// The connected pieces: cells that share a side, not only a corner. Outlines run counter-clockwise, holes
    /// clockwise.
    /// </summary>
    public IEnumerable<(IReadOnlyList<(int X, int Y)> Outline, IReadOnlyList<IReadOnlyList<(int X, int Y)>> Holes)>
        Patches()
    {
        int patch = 0;
        for (int cell = 0; cell < _isFilled.Length; cell++)
        {
            if (!_isFilled[cell] || _patch[cell] != 0)
                continue;
            List<(int X, int Y)>[] loops = [.. Loops(Mark(cell, ++patch), patch)];

            // The one around all is the only one that runs counter-clockwise.
            yield return (loops.First(l => DoubleArea(l) > 0), [.. loops.Where(l => DoubleArea(l) < 0)]);
        }
    }

    private static (double Left, double Right) Span((double X, double Y)[] corners, double y)
    {
        (double left, double right) = (double.PositiveInfinity, double.NegativeInfinity);
        for (int index = 0; index < corners.Length; index++)
        {
            (double X, double Y) a = corners[index];
            (double X, double Y) b = corners[(index + 1) % corners.Length];
            if ((a.Y > y) == (b.Y > y))
                continue;
            double x = a.X + ((b.X - a.X) * (y - a.Y) / (b.Y - a.Y));
            (left, right) = (Math.Min(left, x), Math.Max(right, x));
        }

        return (left, right);
    }

    private List<int> Mark(int first, int patch)
    {
        var cells = new List<int> { first };
        _patch[first] = patch;
        for (int index = 0; index < cells.Count; index++)
        {
            (int x, int y) = (cells[index] % columns, cells[index] / columns);
            foreach ((int nextX, int nextY) in new[] { (x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1) })
            {
                int next = (nextY * columns) + nextX;
                bool isInside = nextX >= 0 && nextY >= 0 && nextX < columns && nextY < rows;
                if (!isInside || !_isFilled[next] || _patch[next] != 0)
                    continue;
                _patch[next] = patch;
                cells.Add(next);
            }
        }

        return cells;
    }

    // Sides with the patch on their left, chained to loops.
    private IEnumerable<List<(int X, int Y)>> Loops(List<int> cells, int patch)
    {
        var sides = new Dictionary<(int X, int Y), List<(int X, int Y)>>();
        foreach (int cell in cells)
        {
            (int x, int y) = (cell % columns, cell / columns);
            AddSide(sides, IsOf(patch, x, y - 1), (x, y), (x + 1, y));
            AddSide(sides, IsOf(patch, x + 1, y), (x + 1, y), (x + 1, y + 1));
            AddSide(sides, IsOf(patch, x, y + 1), (x + 1, y + 1), (x, y + 1));
            AddSide(sides, IsOf(patch, x - 1, y), (x, y + 1), (x, y));
        }

        foreach ((int X, int Y) start in sides.Keys.OrderBy(k => k.Y).ThenBy(k => k.X).ToArray())
        {
            while (sides[start].Count > 0)
                yield return Loop(sides, start);
        }
    }

    private static List<(int X, int Y)> Loop(
        Dictionary<(int X, int Y), List<(int X, int Y)>> sides, (int X, int Y) start)
    {
        var loop = new List<(int X, int Y)>();
        (int X, int Y) at = start;
        (int X, int Y) heading = default;
        do
        {
            List<(int X, int Y)> ways = sides[at];

            // Two cells that touch at a corner: the way to the right stays beside the same empty cell, so that no loop
            // passes a corner twice.
            (int X, int Y) next = ways.Count == 1 ? ways[0] : ways.OrderBy(w => Turn(heading, at, w)).First();
            ways.Remove(next);
            (int X, int Y) way = (next.X - at.X, next.Y - at.Y);
            if (way != heading)
                loop.Add(at);
            (at, heading) = (next, way);
        }
        while (at != start);
        return loop;
    }

    private static int Turn((int X, int Y) heading, (int X, int Y) at, (int X, int Y) to)
        => (heading.X * (to.Y - at.Y)) - (heading.Y * (to.X - at.X));

    private static void AddSide(
        Dictionary<(int X, int Y), List<(int X, int Y)>> sides, bool isInside, (int X, int Y) from, (int X, int Y) to)
    {
        if (isInside)
            return;
        if (!sides.TryGetValue(from, out List<(int X, int Y)>? ways))
            sides.Add(from, ways = []);
        ways.Add(to);
    }

    private bool IsOf(int patch, int x, int y)
        => x >= 0 && y >= 0 && x < columns && y < rows && _patch[(y * columns) + x] == patch;

    private static long DoubleArea(List<(int X, int Y)> loop)
    {
        long area = 0;
        for (int index = 0; index < loop.Count; index++)
        {
            (int X, int Y) next = loop[(index + 1) % loop.Count];
            area += ((long)loop[index].X * next.Y) - ((long)next.X * loop[index].Y);
        }

        return area;
    }
}
