using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The outline of all places within a margin of an area and of the straight way to it from home: a contour of their
/// distance (marching squares), simplified.
/// </summary>
internal static class FenceOutline
{
    // Autopilots store some 80 corners, and the keep-outs need some.
    private const int MaxCorners = 48;
    private const int MaxCells = 150;

    // Where the hull is no more than this much larger, it is taken: fewer corners, and every straight path is in it.
    private const double MaxHullFactor = 1.02;

    /// <summary>Whether the hull of an area is hardly larger than itself.</summary>
    public static bool IsNearlyConvex(PlanePolygon area)
        => PlanePolygon.HullOf(area.Corners).Area <= MaxHullFactor * area.Area;

    /// <summary>The outline.</summary>
    /// <param name="area">The area.</param>
    /// <param name="home">Home.</param>
    /// <param name="margin">Metres.</param>
    public static PlanePolygon Of(PlanePolygon area, PlanePoint home, double margin)
    {
        if (IsNearlyConvex(area))
            return PlanePolygon.HullOf(area.Corners.Concat([home])).Grown(margin);
        PlanePoint gate = Enumerable.Range(0, area.Corners.Count)
            .Select(i => PlanePolygon.NearestOfSegment(home, area.Corners[i], area.After(i)))
            .OrderBy(p => p.DistanceTo(home)).First();
        bool isInside = area.Contains(home);
        double north = area.Corners.Concat([home]).Max(c => c.North) + (2 * margin);
        double east = area.Corners.Concat([home]).Max(c => c.East) + (2 * margin);
        double south = area.Corners.Concat([home]).Min(c => c.North) - (2 * margin);
        double west = area.Corners.Concat([home]).Min(c => c.East) - (2 * margin);
        double step = Math.Max(Math.Max(1, margin / 8), Math.Max(north - south, east - west) / MaxCells);
        for (double tolerance = step / 2; ; tolerance *= 1.5)
        {
            double level = margin + tolerance;
            List<PlanePoint> ring = Contour(
                p => level - Away(p), new PlanePoint(south - step, west - step),
                (int)Math.Ceiling((north - south) / step) + 3, (int)Math.Ceiling((east - west) / step) + 3, step);
            List<PlanePoint> corners = Simplified(ring, tolerance);
            if (corners.Count <= MaxCorners)
                return new PlanePolygon(corners);
        }

        double Away(PlanePoint p)
        {
            double away = -area.SignedDistance(p);
            return isInside ? away : Math.Min(away, PlanePolygon.DistanceToSegment(p, home, gate));
        }
    }

    /// <summary>
    /// The outline of the largest part of an area that is a distance away from its border; null where there is none.
    /// </summary>
    /// <param name="area">The area.</param>
    /// <param name="distance">Metres.</param>
    public static PlanePolygon? Inside(PlanePolygon area, double distance)
    {
        double north = area.Corners.Max(c => c.North);
        double east = area.Corners.Max(c => c.East);
        double south = area.Corners.Min(c => c.North);
        double west = area.Corners.Min(c => c.East);
        double step = Math.Max(1, Math.Max(north - south, east - west) / MaxCells);
        for (double tolerance = step / 2; ; tolerance *= 1.5)
        {
            double level = distance + tolerance;
            List<PlanePoint>? ring = FindContour(
                p => area.SignedDistance(p) - level, new PlanePoint(south - step, west - step),
                (int)Math.Ceiling((north - south) / step) + 3, (int)Math.Ceiling((east - west) / step) + 3, step);
            if (ring is null)
                return null;
            List<PlanePoint> corners = Simplified(ring, tolerance);
            if (corners.Count is >= 3 and <= MaxCorners)
                return new PlanePolygon(corners);
            if (corners.Count < 3)
                return null;
        }
    }

    // The longest line on which a function of place is zero; it is above zero inside.
    private static List<PlanePoint> Contour(
        Func<PlanePoint, double> f, PlanePoint corner, int rows, int columns, double step)
        => FindContour(f, corner, rows, columns, step)!;

    private static List<PlanePoint>? FindContour(
        Func<PlanePoint, double> f, PlanePoint corner, int rows, int columns, double step)
    {
        var values = new double[rows + 1, columns + 1];
        for (int i = 0; i <= rows; i++)
        {
            for (int j = 0; j <= columns; j++)
                values[i, j] = f(At(i, j));
        }

        // From each crossed side of a cell to the side at which the line leaves it, the inside to its left.
        var next = new Dictionary<(int, int, int), (int, int, int)>();
        for (int i = 0; i < rows; i++)
        {
            for (int j = 0; j < columns; j++)
                AddCell(values, i, j, next);
        }

        var rings = new List<List<PlanePoint>>();
        while (next.Count > 0)
        {
            (int, int, int) start = next.Keys.First();
            var ring = new List<PlanePoint>();
            for ((int, int, int) at = start; next.TryGetValue(at, out (int, int, int) then); at = then)
            {
                next.Remove(at);
                ring.Add(Crossing(at));
            }

            rings.Add(ring);
        }

        return rings.OrderByDescending(r => new PlanePolygon(r).Area).FirstOrDefault();

        PlanePoint At(int i, int j) => corner + new PlanePoint(i * step, j * step);

        PlanePoint Crossing((int I, int J, int Side) at)
        {
            (int i, int j) = at.Side == 0 ? (at.I, at.J + 1) : (at.I + 1, at.J);
            double a = values[at.I, at.J];
            return At(at.I, at.J) + (a / (a - values[i, j]) * (At(i, j) - At(at.I, at.J)));
        }
    }

    // Sides are named by their first corner: 0 to the east of it, 1 to the north.
    private static void AddCell(
        double[,] values, int i, int j, Dictionary<(int, int, int), (int, int, int)> next)
    {
        bool sw = values[i, j] > 0;
        bool se = values[i, j + 1] > 0;
        bool ne = values[i + 1, j + 1] > 0;
        bool nw = values[i + 1, j] > 0;
        (int, int, int) south = (i, j, 0);
        (int, int, int) east = (i, j + 1, 1);
        (int, int, int) north = (i + 1, j, 0);
        (int, int, int) west = (i, j, 1);
        var into = new List<(int, int, int)>();
        var outOf = new List<(int, int, int)>();
        Side(sw, se, south);
        Side(se, ne, east);
        Side(ne, nw, north);
        Side(nw, sw, west);

        // In a saddle two lines pass: they are kept apart.
        double middle = values[i, j] + values[i, j + 1] + values[i + 1, j] + values[i + 1, j + 1];
        bool areCrossed = into.Count == 2 && middle <= 0;
        for (int k = 0; k < into.Count; k++)
            next[into[k]] = outOf[areCrossed ? 1 - k : k];

        // Along the border of the cell from inside to outside a line comes in, and the other way it goes out.
        void Side(bool from, bool to, (int, int, int) side)
        {
            if (from && !to)
                into.Add(side);
            else if (!from && to)
                outOf.Add(side);
        }
    }

    private static List<PlanePoint> Simplified(List<PlanePoint> ring, double tolerance)
    {
        int half = ring.Count / 2;
        List<PlanePoint> first = Chain(ring.GetRange(0, half + 1), tolerance);
        List<PlanePoint> second = Chain(ring.GetRange(half, ring.Count - half).Concat([ring[0]]).ToList(), tolerance);
        return first.Take(first.Count - 1).Concat(second.Take(second.Count - 1)).ToList();
    }

    // Ramer, Douglas and Peucker.
    private static List<PlanePoint> Chain(List<PlanePoint> points, double tolerance)
    {
        int farthest = 0;
        double far = 0;
        for (int i = 1; i + 1 < points.Count; i++)
        {
            double distance = PlanePolygon.DistanceToSegment(points[i], points[0], points[points.Count - 1]);
            if (distance > far)
                (farthest, far) = (i, distance);
        }

        if (far <= tolerance)
            return [points[0], points[points.Count - 1]];
        List<PlanePoint> before = Chain(points.GetRange(0, farthest + 1), tolerance);
        before.AddRange(Chain(points.GetRange(farthest, points.Count - farthest), tolerance).Skip(1));
        return before;
    }
}
