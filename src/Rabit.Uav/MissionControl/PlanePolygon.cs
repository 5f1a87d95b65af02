using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>A polygon of the ground plane without holes, its first corner not repeated. Immutable.</summary>
internal sealed class PlanePolygon
{
    public PlanePolygon(IEnumerable<PlanePoint> corners) => Corners = corners.ToArray();

    public IReadOnlyList<PlanePoint> Corners { get; }

    /// <summary>Square metres.</summary>
    public double Area => Math.Abs(SignedArea);

    private double SignedArea
    {
        get
        {
            // Relative to the first corner: far from the origin large products would cancel.
            double twice = 0;
            for (int i = 1; i + 1 < Corners.Count; i++)
                twice += (Corners[i] - Corners[0]).Cross(Corners[i + 1] - Corners[0]);
            return twice / 2;
        }
    }

    /// <summary>The corner after another one.</summary>
    public PlanePoint After(int corner) => Corners[(corner + 1) % Corners.Count];

    /// <summary>Whether a point is inside (even-odd rule); on the border either result may come.</summary>
    public bool Contains(PlanePoint p)
    {
        bool isInside = false;
        for (int i = 0; i < Corners.Count; i++)
        {
            PlanePoint a = Corners[i];
            PlanePoint b = After(i);
            if ((a.North > p.North) != (b.North > p.North)
                && p.East < a.East + ((b.East - a.East) * (p.North - a.North) / (b.North - a.North)))
            {
                isInside = !isInside;
            }
        }

        return isInside;
    }

    /// <summary>Distance to the nearest edge, metres, positive inside.</summary>
    public double SignedDistance(PlanePoint p)
    {
        double min = double.PositiveInfinity;
        for (int i = 0; i < Corners.Count; i++)
            min = Math.Min(min, DistanceToSegment(p, Corners[i], After(i)));
        return Contains(p) ? min : -min;
    }

    /// <summary>
    /// Two edges that cross or touch without being neighbours, or that fold back; null when there are none.
    /// </summary>
    public (int First, int Second)? FindCrossing()
    {
        int count = Corners.Count;
        for (int i = 0; i < count; i++)
        {
            for (int j = i + 1; j < count; j++)
            {
                bool areNeighbours = j == i + 1 || (i == 0 && j == count - 1);
                bool isFault = areNeighbours
                    ? count > 2 && FoldsBack(j == i + 1 ? i : j)
                    : Intersect(Corners[i], After(i), Corners[j], After(j));
                if (isFault)
                    return (i, j);
            }
        }

        return null;
    }

    /// <summary>The smallest convex polygon around points (Andrew's monotone chain).</summary>
    public static PlanePolygon HullOf(IEnumerable<PlanePoint> points)
    {
        PlanePoint[] sorted = points.OrderBy(p => p.North).ThenBy(p => p.East).ToArray();
        var hull = new List<PlanePoint>();
        AddChain(hull, sorted);
        Array.Reverse(sorted);
        AddChain(hull, sorted);
        return new PlanePolygon(hull);
    }

    /// <summary>
    /// This convex polygon, offset outwards by a distance (buffer); up to 2 % more than needed at its corners.
    /// </summary>
    public PlanePolygon Grown(double metres)
    {
        const int Directions = 16;
        double reach = metres / Trig.Cos(Math.PI / Directions);
        return HullOf(Corners.SelectMany(c => Enumerable.Range(0, Directions)
            .Select(i => c + (reach * PlanePoint.Towards(2 * Math.PI * i / Directions)))));
    }

    /// <summary>
    /// How much the border turns at a corner, radians: above zero at a convex corner, below zero at a reflex one.
    /// </summary>
    public double TurnAt(int corner)
    {
        PlanePoint before = Corners[corner] - Corners[(corner + Corners.Count - 1) % Corners.Count];
        PlanePoint after = After(corner) - Corners[corner];
        return Math.Sign(SignedArea) * Math.Atan2(before.Cross(after), before.Dot(after));
    }

    /// <summary>
    /// Heading of the outward normal of the edge before a corner, turned by a part of the turn there.
    /// </summary>
    public double NormalBefore(int corner, double turnRadians)
    {
        PlanePoint before = Corners[corner] - Corners[(corner + Corners.Count - 1) % Corners.Count];
        int side = Math.Sign(SignedArea);
        return before.HeadingRadians - (side * Math.PI / 2) + (side * turnRadians);
    }

    /// <summary>Distance of a segment from this polygon, 0 where it meets it, metres.</summary>
    public double DistanceTo(PlanePoint a, PlanePoint b)
    {
        if (Contains(a))
            return 0;
        double min = double.PositiveInfinity;
        for (int i = 0; i < Corners.Count; i++)
        {
            PlanePoint c = Corners[i];
            PlanePoint d = After(i);
            if (Crossing(a, b, c, d) is not null)
                return 0;
            min = Math.Min(min, Math.Min(DistanceToSegment(a, c, d), DistanceToSegment(b, c, d)));
            min = Math.Min(min, DistanceToSegment(c, a, b));
        }

        return min;
    }

    /// <summary>Where a segment crosses an edge, 0 to 1 along the segment; null where it does not.</summary>
    public static double? Crossing(PlanePoint a, PlanePoint b, PlanePoint c, PlanePoint d)
    {
        PlanePoint way = b - a;
        PlanePoint edge = d - c;
        double cross = way.Cross(edge);
        if (Math.Abs(cross) <= 1e-12 * way.Length * edge.Length)
            return null;
        double t = (c - a).Cross(edge) / cross;
        double u = (c - a).Cross(way) / cross;
        return t >= 0 && t <= 1 && u >= 0 && u <= 1 ? t : null;
    }

    /// <summary>
    /// Where a segment crosses or touches the border, 0 to 1 along it, in order, with its ends. Corners that it touches
    /// are among them also where rounding says that no edge is crossed.
    /// </summary>
    public List<double> CrossingsOf(PlanePoint a, PlanePoint b)
    {
        const double Touching = 1e-3;
        double length = a.DistanceTo(b);
        var crossings = new List<double> { 0, 1 };
        for (int i = 0; i < Corners.Count; i++)
        {
            if (Crossing(a, b, Corners[i], After(i)) is { } t)
                crossings.Add(t);
            PlanePoint nearest = NearestOfSegment(Corners[i], a, b);
            if (nearest.DistanceTo(Corners[i]) < Touching && length > 0)
                crossings.Add(a.DistanceTo(nearest) / length);
        }

        crossings.Sort();
        return crossings;
    }

    /// <summary>Where the line across a direction crosses the border, in order: inside between each pair.</summary>
    /// <param name="along">Unit vector.</param>
    /// <param name="right">Unit vector to the right of it.</param>
    /// <param name="u">Place of the line along the direction.</param>
    public List<double> CrossingsAt(PlanePoint along, PlanePoint right, double u)
    {
        var crossings = new List<double>();
        for (int i = 0; i < Corners.Count; i++)
        {
            double ua = Corners[i].Dot(along);
            double ub = After(i).Dot(along);
            if ((ua < u) == (ub < u))
                continue;
            double va = Corners[i].Dot(right);
            crossings.Add(va + ((u - ua) / (ub - ua) * (After(i).Dot(right) - va)));
        }

        crossings.Sort();
        return crossings;
    }

    /// <summary>The parts of that line that are inside or within a distance of the border.</summary>
    public IEnumerable<(double Low, double High)> NearAt(PlanePoint along, PlanePoint right, double u, double metres)
    {
        List<double> crossings = CrossingsAt(along, right, u);
        for (int i = 0; i + 1 < crossings.Count; i += 2)
            yield return (crossings[i], crossings[i + 1]);
        for (int i = 0; i < Corners.Count; i++)
        {
            PlanePoint a = Corners[i];
            PlanePoint edge = After(i) - a;
            double ua = a.Dot(along) - u;
            double va = a.Dot(right);
            if (Math.Abs(ua) < metres)
            {
                double half = Math.Sqrt((metres * metres) - (ua * ua));
                yield return (va - half, va + half);
            }

            // The band along the edge: on both sides of it, between its ends.
            double eu = edge.Dot(along) / edge.Length;
            double ev = edge.Dot(right) / edge.Length;
            double[] ends =
            [
                Bound(ua - (metres * ev), va + (metres * eu)), Bound(ua + (metres * ev), va - (metres * eu)),
                Cap(ua, va), Cap(ua + (edge.Length * eu), va + (edge.Length * ev)),
            ];
            double[] inBand = ends.Where(v => !double.IsNaN(v)).ToArray();
            if (inBand.Length >= 2)
                yield return (inBand.Min(), inBand.Max());

            double Bound(double fromU, double fromV)
            {
                double t = -fromU / eu;
                return Math.Abs(eu) > 1e-9 && t >= 0 && t <= edge.Length ? fromV + (t * ev) : double.NaN;
            }

            double Cap(double fromU, double fromV)
            {
                double t = -fromU / ev;
                return Math.Abs(ev) > 1e-9 && Math.Abs(t) <= metres ? fromV - (t * eu) : double.NaN;
            }
        }
    }

    private static void AddChain(List<PlanePoint> hull, PlanePoint[] sorted)
    {
        int start = hull.Count;
        foreach (PlanePoint p in sorted)
        {
            while (hull.Count - start >= 2
                && (hull[hull.Count - 1] - hull[hull.Count - 2]).Cross(p - hull[hull.Count - 1]) <= 0)
                hull.RemoveAt(hull.Count - 1);
            hull.Add(p);
        }

        // The last is the first of the other chain.
        hull.RemoveAt(hull.Count - 1);
    }

    /// <summary>Distance of a point from a segment, metres.</summary>
    public static double DistanceToSegment(PlanePoint p, PlanePoint a, PlanePoint b)
        => p.DistanceTo(NearestOfSegment(p, a, b));

    /// <summary>The point of a segment that is nearest to another.</summary>
    public static PlanePoint NearestOfSegment(PlanePoint p, PlanePoint a, PlanePoint b)
    {
        PlanePoint edge = b - a;
        double length2 = edge.Dot(edge);
        double t = length2 > 0 ? Math.Max(0, Math.Min(1, (p - a).Dot(edge) / length2)) : 0;
        return a + (t * edge);
    }

    // An edge that goes back along the one before it.
    private bool FoldsBack(int edge)
    {
        PlanePoint first = After(edge) - Corners[edge];
        PlanePoint second = After((edge + 1) % Corners.Count) - After(edge);
        return Math.Abs(first.Cross(second)) <= 1e-9 * first.Length * second.Length && first.Dot(second) <= 0;
    }

    private static bool Intersect(PlanePoint a, PlanePoint b, PlanePoint c, PlanePoint d)
    {
        double ab1 = (b - a).Cross(c - a);
        double ab2 = (b - a).Cross(d - a);
        double cd1 = (d - c).Cross(a - c);
        double cd2 = (d - c).Cross(b - c);
        if (((ab1 > 0 && ab2 < 0) || (ab1 < 0 && ab2 > 0)) && ((cd1 > 0 && cd2 < 0) || (cd1 < 0 && cd2 > 0)))
            return true;

        // Corners that lie on another edge.
        const double Touching = 1e-6;
        return DistanceToSegment(a, c, d) < Touching || DistanceToSegment(b, c, d) < Touching
            || DistanceToSegment(c, a, b) < Touching || DistanceToSegment(d, a, b) < Touching;
    }
}
