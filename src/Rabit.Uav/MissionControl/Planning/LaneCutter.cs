using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Cuts a region into parallel strips and each strip into cells (boustrophedon decomposition); the lane of a cell runs
/// along the middle of its strip, and along the border of the region where the middle is outside.
/// </summary>
internal sealed class LaneCutter
{
    private const int MaxSteps = 6000;

    private readonly SearchRegion _region;
    private readonly PlanePoint _along;
    private readonly PlanePoint _right;

    private LaneCutter(SearchRegion region, double heading)
    {
        _region = region;
        _along = PlanePoint.Towards(heading);
        _right = new PlanePoint(-_along.East, _along.North);
    }

    /// <summary>The lanes, strip by strip, each from one end to the other.</summary>
    /// <param name="region">The region.</param>
    /// <param name="spacing">Maximum width of a strip, metres.</param>
    /// <param name="heading">Direction of the lanes, radians clockwise from north.</param>
    /// <param name="strip">Width of a strip.</param>
    public static List<List<PlanePoint>> Cut(
        SearchRegion region, double spacing, double heading, out double strip)
    {
        var cutter = new LaneCutter(region, heading);
        double[] offsets = region.Outer.Corners.Select(c => c.Dot(cutter._right)).ToArray();
        double from = offsets.Min();
        int count = Math.Max(1, (int)Math.Ceiling(((offsets.Max() - from) / spacing) - 1e-6));
        double width = (offsets.Max() - from) / count;
        strip = width;
        double step = Math.Max(spacing / 8, region.Outer.Area / spacing / MaxSteps);
        return Enumerable.Range(0, count)
            .SelectMany(i => cutter.Lanes(from + (i * width), from + ((i + 1) * width), step)).ToList();
    }

    private IEnumerable<List<PlanePoint>> Lanes(double from, double to, double step)
    {
        double middle = (from + to) / 2;
        var open = new List<Cell>();
        var done = new List<Cell>();
        foreach (double u in Steps(from, to, step))
        {
            var next = new List<Cell>();
            foreach ((double low, double high) in FreeAt(u, from, to))
            {
                PlanePoint p = (u * _along) + (Math.Max(low, Math.Min(high, middle)) * _right);
                Cell? cell = open
                    .Where(c => c.Overlap(low, high) > 0 && _region.IsFree(c.Points[c.Points.Count - 1], p))
                    .OrderByDescending(c => c.Overlap(low, high)).FirstOrDefault();
                if (cell is null)
                    cell = new Cell();
                else
                    open.Remove(cell);
                cell.Points.Add(p);
                (cell.Low, cell.High) = (low, high);
                next.Add(cell);
            }

            done.AddRange(open);
            open = next;
        }

        done.AddRange(open);
        double tolerance = (to - from) / 50;
        return done.Select(c => Simplified(c.Points, tolerance));
    }

    // Places along the strip: evenly, and on either side of each corner and of each crossing of an edge with its lines.
    private List<double> Steps(double from, double to, double step)
    {
        const double Side = 1e-4;
        double middle = (from + to) / 2;
        var places = new List<double>();
        foreach (PlanePolygon polygon in _region.KeepOuts.Concat([_region.Outer]))
        {
            double clearance = ReferenceEquals(polygon, _region.Outer) ? 0 : _region.ClearanceMetres;
            for (int i = 0; i < polygon.Corners.Count; i++)
            {
                PlanePoint a = polygon.Corners[i];
                PlanePoint b = polygon.After(i);
                (double va, double vb) = (a.Dot(_right), b.Dot(_right));
                if (va >= from - clearance && va <= to + clearance)
                    Add(a.Dot(_along), clearance);
                foreach (double line in new[] { from, middle, to })
                {
                    if ((va < line) != (vb < line))
                        Add((a + ((line - va) / (vb - va) * (b - a))).Dot(_along), clearance);
                }
            }
        }

        places.Sort();
        if (places.Count == 0)
            return places;
        double first = places[0];
        double last = places[places.Count - 1];
        int count = (int)Math.Ceiling((last - first) / step);
        places.AddRange(Enumerable.Range(1, Math.Max(0, count - 1)).Select(k => first + ((last - first) * k / count)));
        places.Sort();
        return places;

        void Add(double u, double clearance)
        {
            places.Add(u - clearance - Side);
            places.Add(u + clearance + Side);
        }
    }

    // The free intervals across the strip.
    private List<(double Low, double High)> FreeAt(double u, double from, double to)
    {
        var free = new List<(double Low, double High)>();
        foreach ((double low, double high) in InOuter(u))
        {
            if (Math.Max(low, from) < Math.Min(high, to))
                free.Add((Math.Max(low, from), Math.Min(high, to)));
        }

        foreach (PlanePolygon keepOut in _region.KeepOuts)
        {
            foreach ((double low, double high) in keepOut.NearAt(_along, _right, u, _region.ClearanceMetres))
                free = Without(free, low, high);
        }

        return free;
    }

    private IEnumerable<(double Low, double High)> InOuter(double u)
    {
        List<double> cuts = _region.Outer.CrossingsAt(_along, _right, u);
        return Enumerable.Range(0, cuts.Count / 2).Select(i => (cuts[2 * i], cuts[(2 * i) + 1]));
    }

    private static List<(double Low, double High)> Without(
        List<(double Low, double High)> intervals, double low, double high)
    {
        var rest = new List<(double Low, double High)>();
        foreach ((double a, double b) in intervals)
        {
            if (a < Math.Min(b, low))
                rest.Add((a, Math.Min(b, low)));
            if (Math.Max(a, high) < b)
                rest.Add((Math.Max(a, high), b));
        }

        return rest;
    }

    // Ramer, Douglas and Peucker, as far as the way stays in the region.
    private List<PlanePoint> Simplified(List<PlanePoint> points, double tolerance)
    {
        if (points.Count < 3)
            return points;
        PlanePoint first = points[0];
        PlanePoint last = points[points.Count - 1];
        int farthest = 0;
        double far = 0;
        for (int i = 1; i + 1 < points.Count; i++)
        {
            double distance = PlanePolygon.DistanceToSegment(points[i], first, last);
            if (distance > far)
                (farthest, far) = (i, distance);
        }

        if (far <= tolerance && _region.IsFree(first, last))
            return [first, last];
        farthest = farthest == 0 ? points.Count / 2 : farthest;
        List<PlanePoint> before = Simplified(points.GetRange(0, farthest + 1), tolerance);
        before.AddRange(Simplified(points.GetRange(farthest, points.Count - farthest), tolerance).Skip(1));
        return before;
    }

    private sealed class Cell
    {
        public List<PlanePoint> Points { get; } = [];

        public double Low { get; set; }

        public double High { get; set; }

        public double Overlap(double low, double high) => Math.Min(high, High) - Math.Max(low, Low);
    }
}
