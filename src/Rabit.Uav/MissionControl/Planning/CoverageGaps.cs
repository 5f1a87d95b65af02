using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Where a way leaves ground of a region uncovered. Squares are divided until each is covered, and of those that are
/// too small to be divided also what may be uncovered counts: where it finds nothing, every point is covered.
/// </summary>
internal sealed class CoverageGaps
{
    /// <summary>
    /// How far ground may be from a way, in parts of the radius, that is not sure to be found covered.
    /// </summary>
    public const double Resolution = 0.0025;

    // Wholly uncovered squares are not divided further than this.
    private const double CoarseResolution = 0.3;

    // Gaps nearer to another than this are one.
    private const double Separation = 0.05;

    private readonly SearchRegion _region;
    private readonly double _radius;
    private readonly List<PlanePoint> _gaps = [];
    private readonly HashSet<(long, long)> _places = [];

    private CoverageGaps(SearchRegion region, double radius) => (_region, _radius) = (region, radius);

    /// <summary>Points of it all.</summary>
    /// <param name="region">The ground.</param>
    /// <param name="way">The corners of the way.</param>
    /// <param name="radius">A leg covers what is within this of it, metres.</param>
    public static List<PlanePoint> Find(SearchRegion region, IReadOnlyList<PlanePoint> way, double radius)
    {
        var gaps = new CoverageGaps(region, radius);
        LaneSegment[] legs = Enumerable.Range(0, Math.Max(1, way.Count - 1))
            .Select(i => new LaneSegment(way[i], way[Math.Min(i + 1, way.Count - 1)])).ToArray();
        double north = region.Outer.Corners.Max(c => c.North);
        double east = region.Outer.Corners.Max(c => c.East);
        double south = region.Outer.Corners.Min(c => c.North);
        double west = region.Outer.Corners.Min(c => c.East);
        gaps.Check(
            new PlanePoint((north + south) / 2, (east + west) / 2), Math.Max(north - south, east - west) / 2, legs,
            isInside: false);
        return gaps._gaps;
    }

    private void Check(PlanePoint centre, double half, LaneSegment[] legs, bool isInside)
    {
        double reach = half * Math.Sqrt(2);
        if (!isInside)
        {
            double depth = _region.Outer.SignedDistance(centre);
            foreach (PlanePolygon keepOut in _region.KeepOuts)
                depth = Math.Min(depth, -keepOut.SignedDistance(centre));
            if (depth < -reach)
                return;
            isInside = depth > reach;
        }

        double least = double.PositiveInfinity;
        var near = new List<LaneSegment>(legs.Length);
        foreach (LaneSegment leg in legs)
        {
            double distance = leg.DistanceTo(centre);
            least = Math.Min(least, distance);
            if (distance <= _radius + reach)
                near.Add(leg);
        }

        if (least + reach <= _radius)
            return;
        if (reach <= (near.Count == 0 ? CoarseResolution : Resolution) * _radius)
        {
            Add(centre);
            return;
        }

        LaneSegment[] rest = near.ToArray();
        double quarter = half / 2;
        Check(centre + new PlanePoint(quarter, quarter), quarter, rest, isInside);
        Check(centre + new PlanePoint(quarter, -quarter), quarter, rest, isInside);
        Check(centre + new PlanePoint(-quarter, quarter), quarter, rest, isInside);
        Check(centre + new PlanePoint(-quarter, -quarter), quarter, rest, isInside);
    }

    private void Add(PlanePoint p)
    {
        double step = Separation * _radius;
        if (_places.Add(((long)Math.Floor(p.North / step), (long)Math.Floor(p.East / step))))
            _gaps.Add(p);
    }
}
