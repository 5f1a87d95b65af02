using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Where a search may fly: an area without its keep-outs and a clearance around those. Shortest paths in it go straight
/// or by the corners of a visibility graph. Immutable.
/// </summary>
internal sealed class SearchRegion
{
    // Rounding: what touches the border is inside.
    private const double Tolerance = 1e-3;

    private readonly double _limit;
    private readonly PlanePoint[] _nodes;
    private readonly double[,] _distances;
    private readonly int[,] _next;

    /// <param name="outer">The outer border.</param>
    /// <param name="keepOuts">Where it may not fly.</param>
    /// <param name="clearanceMetres">Distance from these.</param>
    /// <param name="reachMetres">How far outside the outer border it may fly.</param>
    /// <param name="slackMetres">
    /// How much nearer to the keep-outs than the clearance it may be between the corners of a path, for a vehicle that
    /// is not exactly where it should be.
    /// </param>
    public SearchRegion(
        PlanePolygon outer, IReadOnlyList<PlanePolygon> keepOuts, double clearanceMetres, double reachMetres = 0,
        double slackMetres = 0)
    {
        (Outer, KeepOuts, ClearanceMetres, ReachMetres) = (outer, keepOuts, clearanceMetres, reachMetres);
        _limit = clearanceMetres - slackMetres;
        _nodes = CornersOf(outer).Concat(keepOuts.SelectMany(CornersAround)).Where(IsFree).ToArray();
        (_distances, _next) = AllPaths();
    }

    public PlanePolygon Outer { get; }

    public IReadOnlyList<PlanePolygon> KeepOuts { get; }

    public double ClearanceMetres { get; }

    public double ReachMetres { get; }

    /// <summary>Whether every straight path between two points of it is in it.</summary>
    public bool IsConvex => _nodes.Length == 0 && KeepOuts.Count == 0;

    /// <summary>Whether a point belongs to the ground that is to be searched.</summary>
    public bool Contains(PlanePoint p) => Outer.Contains(p) && !KeepOuts.Any(k => k.Contains(p));

    /// <summary>Whether the vehicle may be at a point.</summary>
    public bool IsFree(PlanePoint p)
        => Outer.SignedDistance(p) >= -Tolerance - ReachMetres
            && KeepOuts.All(k => k.SignedDistance(p) <= Tolerance - _limit);

    /// <summary>Whether it may fly straight from one point to another, both of which are free.</summary>
    public bool IsFree(PlanePoint a, PlanePoint b)
    {
        foreach (PlanePolygon keepOut in KeepOuts)
        {
            if (keepOut.DistanceTo(a, b) < _limit - Tolerance)
                return false;
        }

        return IsInside(a, b);
    }

    /// <summary>The nodes of the graph that can be seen from a point.</summary>
    public int[] NodesFrom(PlanePoint p)
        => Enumerable.Range(0, _nodes.Length).Where(i => IsFree(p, _nodes[i])).ToArray();

    /// <summary>Length of the shortest path between two free points; infinite where there is none.</summary>
    public double Distance(PlanePoint a, int[] nodesFromA, PlanePoint b, int[] nodesFromB)
        => IsFree(a, b) ? a.DistanceTo(b) : Best(a, nodesFromA, b, nodesFromB, out _, out _);

    /// <summary>The points between two free points on the shortest path; null where there is no path.</summary>
    public List<PlanePoint>? PathBetween(PlanePoint a, PlanePoint b)
    {
        var path = new List<PlanePoint>();
        if (IsFree(a, b))
            return path;
        if (double.IsPositiveInfinity(Best(a, NodesFrom(a), b, NodesFrom(b), out int node, out int last)))
            return null;
        path.Add(_nodes[node]);
        while (node != last)
        {
            node = _next[node, last];
            path.Add(_nodes[node]);
        }

        return path;
    }

    private double Best(
        PlanePoint a, int[] nodesFromA, PlanePoint b, int[] nodesFromB, out int first, out int last)
    {
        (double best, first, last) = (double.PositiveInfinity, -1, -1);
        foreach (int i in nodesFromA)
        {
            double toNode = a.DistanceTo(_nodes[i]);
            foreach (int j in nodesFromB)
            {
                double length = toNode + _distances[i, j] + _nodes[j].DistanceTo(b);
                if (length < best)
                    (best, first, last) = (length, i, j);
            }
        }

        return best;
    }

    // Between the places where it crosses or touches an edge it is inside or outside as a whole.
    private bool IsInside(PlanePoint a, PlanePoint b)
    {
        List<double> cuts = Outer.CrossingsOf(a, b);
        for (int i = 0; i + 1 < cuts.Count; i++)
        {
            PlanePoint from = a + (cuts[i] * (b - a));
            PlanePoint to = a + (cuts[i + 1] * (b - a));
            PlanePoint middle = 0.5 * (from + to);
            double depth = Outer.SignedDistance(middle);
            if (depth >= -Tolerance)
                continue;

            // It is at most so much farther away than in the middle.
            int parts = ReachMetres > 0 ? (int)Math.Ceiling(from.DistanceTo(to) / (ReachMetres / 2)) : 1;
            for (int k = 0; k < parts; k++)
            {
                if (Outer.SignedDistance(from + ((k + 0.5) / parts * (to - from))) < -Tolerance - (ReachMetres * 0.75))
                    return false;
            }
        }

        return true;
    }

    // Only around a reflex corner does a shortest path bend.
    private static IEnumerable<PlanePoint> CornersOf(PlanePolygon outer)
        => Enumerable.Range(0, outer.Corners.Count).Where(i => outer.TurnAt(i) < -1e-9).Select(i => outer.Corners[i]);

    // The circle around a convex corner, as the corners of a polygon around it.
    private IEnumerable<PlanePoint> CornersAround(PlanePolygon keepOut)
    {
        const double StepRadians = Math.PI / 4;
        for (int i = 0; i < keepOut.Corners.Count; i++)
        {
            double turn = keepOut.TurnAt(i);
            if (!(turn > 1e-9))
                continue;
            int steps = (int)Math.Ceiling(turn / StepRadians);
            double reach = 1.001 * ClearanceMetres / Trig.Cos(turn / steps / 2);
            for (int k = 0; k < steps; k++)
            {
                double along = turn * ((k + 0.5) / steps);
                yield return keepOut.Corners[i] + (reach * PlanePoint.Towards(keepOut.NormalBefore(i, along)));
            }
        }
    }

    // Floyd and Warshall.
    private (double[,] Distances, int[,] Next) AllPaths()
    {
        int count = _nodes.Length;
        var distances = new double[count, count];
        var next = new int[count, count];
        for (int i = 0; i < count; i++)
        {
            for (int j = 0; j < count; j++)
            {
                next[i, j] = j;
                distances[i, j] = i == j ? 0
                    : j < i ? distances[j, i]
                    : IsFree(_nodes[i], _nodes[j]) ? _nodes[i].DistanceTo(_nodes[j]) : double.PositiveInfinity;
            }
        }

        for (int k = 0; k < count; k++)
        {
            for (int i = 0; i < count; i++)
            {
                for (int j = 0; j < count; j++)
                {
                    double length = distances[i, k] + distances[k, j];
                    if (length < distances[i, j])
                        (distances[i, j], next[i, j]) = (length, next[i, k]);
                }
            }
        }

        return (distances, next);
    }
}
