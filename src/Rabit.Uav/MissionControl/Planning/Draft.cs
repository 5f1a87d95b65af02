using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>A way that covers a region, made from one pattern of lanes.</summary>
internal sealed class Draft
{
    // Nearer to each other than those that the way was planned with.
    private const double FineSamples = 2;
    private const int MaxRounds = 4;

    // Shorter ones have no direction.
    private const double MinLegMetres = 0.5;
    private const double MinWayMetres = 4;

    private readonly SearchRegion _region;
    private readonly double _sweep;
    private readonly double _width;
    private readonly double _heading;
    private readonly List<List<PlanePoint>> _lanes;
    private readonly CoverageSamples _samples;

    private Draft(
        SearchRegion region, double sweep, double width, double heading, List<List<PlanePoint>> lanes,
        CoverageSamples samples)
    {
        (_region, _sweep, _width, _heading, _lanes, _samples) = (region, sweep, width, heading, lanes, samples);
        Way = LaneTrimmer.Join(region, lanes);
    }

    /// <summary>Its corners.</summary>
    public List<PlanePoint> Way { get; private set; }

    /// <summary>Orders lanes; null where one cannot be reached from another.</summary>
    /// <param name="region">The region.</param>
    /// <param name="sweep">Width of what is seen.</param>
    /// <param name="width">Width that a leg is taken to cover: at most the sweep.</param>
    /// <param name="lanes">The lanes.</param>
    /// <param name="heading">Their direction.</param>
    /// <param name="from">Where the vehicle is; null where the way may begin anywhere.</param>
    public static Draft? Of(
        SearchRegion region, double sweep, double width, List<List<PlanePoint>> lanes, double heading,
        PlanePoint? from)
    {
        var samples = new CoverageSamples(region, Radius(width), heading);
        Complete(region, samples, Radius(width), lanes);
        List<(int Lane, bool IsReversed)>? order = LaneOrder.Find(
            region, lanes.Select(l => (l[0], l[l.Count - 1])).ToArray(), from);
        return order is null || order.Count == 0
            ? null
            : new Draft(
                region, sweep, width, heading,
                order.Select(o => o.IsReversed ? Enumerable.Reverse(lanes[o.Lane]).ToList() : lanes[o.Lane]).ToList(),
                samples);
    }

    /// <summary>Shortens the lanes.</summary>
    public Draft Trimmed()
    {
        Way = LaneTrimmer.Trim(_region, _samples, _width, _lanes);
        return this;
    }

    /// <summary>
    /// Shortens the way further. The effort is bounded: at the end gaps that are left are closed as they are.
    /// </summary>
    public Draft Shortened(long maxEffort)
    {
        // Lanes that are as far apart as they may be cannot be moved.
        List<PlanePoint> way = Way;
        if (_width > SearchPlanner.SweepMargin * _sweep)
            return this;
        long effort = maxEffort;
        for (int round = 0; round < MaxRounds; round++)
        {
            way = WayShortener.Shorten(_region, _samples, _width, way, effort);
            List<PlanePoint> gaps = Close(way);
            if (gaps.Count == 0)
                break;
            _samples.Add(gaps);
            effort = maxEffort / 4;
        }

        Way = way;
        return this;
    }

    /// <summary>The way with its legs: what of it covers nothing that is not covered anyway is none.</summary>
    public SearchWay ToWay()
    {
        List<PlanePoint> way = Way;
        _samples.Clear();
        for (int i = 0; i + 1 < way.Count; i++)
            _samples.Change(way[i], way[i + 1], 1);
        var legs = new List<LaneSegment>();
        for (int i = 0; i + 1 < way.Count; i++)
        {
            double length = way[i].DistanceTo(way[i + 1]);
            if (length >= _sweep && _samples.CanReplace([way[i], way[i + 1]], []))
                _samples.Change(way[i], way[i + 1], -1);
            else if (length > MinLegMetres)
                legs.Add(new LaneSegment(way[i], way[i + 1]));
        }

        // A place from which everything is seen.
        if (legs.Count == 0)
            legs.Add(new LaneSegment(way[0], way[0] + new PlanePoint(MinWayMetres, 0)));
        return new SearchWay(way, legs);
    }

    // Rounding.
    private static double Radius(double width) => (width / 2) + 1e-6;

    // Small gaps between the samples are closed by a way over there from the nearest leg.
    private List<PlanePoint> Close(List<PlanePoint> way)
    {
        double radius = Radius(_sweep) * 0.9995;
        var samples = new CoverageSamples(_region, Math.Max(radius, Radius(_width)), _heading, FineSamples);
        for (int i = 0; i < Math.Max(1, way.Count - 1); i++)
            samples.Change(way[i], way[Math.Min(i + 1, way.Count - 1)], 1);
        var gaps = samples.UncoveredPoints().ToList();
        var rest = gaps.ToList();
        while (rest.Count > 0)
        {
            PlanePoint p = rest[0];
            rest.RemoveAt(0);
            if (TryReach(p, way, samples) is { } there)
                rest.RemoveAll(r => r.DistanceTo(there) <= radius);
        }

        return gaps;
    }

    private PlanePoint? TryReach(PlanePoint p, List<PlanePoint> way, CoverageSamples samples)
    {
        int leg = Enumerable.Range(0, Math.Max(1, way.Count - 1))
            .OrderBy(i => PlanePolygon.DistanceToSegment(p, way[i], way[Math.Min(i + 1, way.Count - 1)])).First();
        PlanePoint at = PlanePolygon.NearestOfSegment(p, way[leg], way[Math.Min(leg + 1, way.Count - 1)]);
        double distance = p.DistanceTo(at);
        PlanePoint there = at + ((distance - (0.9 * _width / 2)) / distance * (p - at));
        if (!_region.IsFree(there) || !_region.IsFree(at, there))
            return null;
        List<PlanePoint> old = way.GetRange(leg, Math.Min(2, way.Count - leg));
        List<PlanePoint> by = [old[0], there, old[old.Count - 1]];
        if (!samples.CanReplace(old, by) || !_region.IsFree(by[0], there) || !_region.IsFree(there, by[2]))
            by = [old[0], at, there, at, old[old.Count - 1]];
        for (int i = 0; i + 1 < by.Count; i++)
            samples.Change(by[i], by[i + 1], 1);
        samples.Change(old[0], old[old.Count - 1], -1);
        way.InsertRange(leg + 1, by.GetRange(1, by.Count - 2));
        return there;
    }

    // Places from which the rest is seen, each as a lane of its own.
    private static void Complete(
        SearchRegion region, CoverageSamples samples, double radius, List<List<PlanePoint>> lanes)
    {
        foreach (List<PlanePoint> lane in lanes)
        {
            for (int i = 0; i < Math.Max(1, lane.Count - 1); i++)
                samples.Change(lane[i], lane[Math.Min(i + 1, lane.Count - 1)], 1);
        }

        List<PlanePoint> rest = samples.UncoveredPoints().ToList();
        while (rest.Count > 0)
        {
            PlanePoint p = rest[0];
            PlanePoint? best = Around(p, radius).Where(region.IsFree)
                .OrderByDescending(q => rest.Count(r => r.DistanceTo(q) <= radius)).Cast<PlanePoint?>()
                .FirstOrDefault();
            if (best is { } place)
            {
                lanes.Add([place]);
                samples.Change(place, place, 1);
                rest.RemoveAll(r => r.DistanceTo(place) <= radius);
            }
            else
                rest.RemoveAt(0);
        }

        samples.IgnoreUncovered();
    }

    private static IEnumerable<PlanePoint> Around(PlanePoint p, double radius)
    {
        const int Directions = 16;
        yield return p;
        foreach (double part in new[] { 0.95, 0.7, 0.4 })
        {
            for (int i = 0; i < Directions; i++)
                yield return p + (part * radius * PlanePoint.Towards(2 * Math.PI * i / Directions));
        }
    }
}
