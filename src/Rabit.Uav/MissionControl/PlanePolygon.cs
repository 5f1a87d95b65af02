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
        double reach = metres / Math.Cos(Math.PI / Directions);
        return HullOf(Corners.SelectMany(c => Enumerable.Range(0, Directions)
            .Select(i => c + (reach * PlanePoint.Towards(2 * Math.PI * i / Directions)))));
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

    private static double DistanceToSegment(PlanePoint p, PlanePoint a, PlanePoint b)
    {
        PlanePoint edge = b - a;
        double length2 = edge.Dot(edge);
        double t = length2 > 0 ? Math.Max(0, Math.Min(1, (p - a).Dot(edge) / length2)) : 0;
        return p.DistanceTo(a + (t * edge));
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
