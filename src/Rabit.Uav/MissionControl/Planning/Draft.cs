using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>A way that covers a region, made from one pattern of lanes.</summary>
internal sealed class Draft
{
    private const int MaxRounds = 8;

    // Of the annealing: how far apart the samples are at first, and when there are more.
    private const double CoarseSamples = 0.45;
    private const double CoarsePart = 0.6;
    private const double FineFrom = 0.4;

    // Shorter ones have no direction.
    private const double MinLegMetres = 0.5;
    private const double MinWayMetres = 4;

    private readonly SearchRegion _region;
    private readonly double _sweep;
    private readonly double _width;
    private readonly double _heading;
    private readonly List<List<PlanePoint>> _lanes;
    private readonly CoverageSamples _samples;
    private readonly PlanePoint? _from;

    private Draft(
        SearchRegion region, double sweep, double width, double heading, List<List<PlanePoint>> lanes,
        CoverageSamples samples, PlanePoint? from)
    {
        (_region, _sweep, _width, _heading, _lanes, _samples) = (region, sweep, width, heading, lanes, samples);
        _from = from;
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
                samples, from);
    }

    /// <summary>Shortens the lanes.</summary>
    public Draft Trimmed()
    {
        Way = LaneTrimmer.Trim(_region, _samples, _width, _lanes);
        return this;
    }

    /// <summary>Changes the way at random and keeps what is shorter, first on few samples, then on all.</summary>
    public Draft Annealed(long maxEffort, ulong seed)
    {
        var coarse = new CoverageSamples(_region, Radius(_width), _heading, CoarseSamples);
        for (int i = 0; i < Math.Max(1, Way.Count - 1); i++)
            coarse.Change(Way[i], Way[Math.Min(i + 1, Way.Count - 1)], 1);
        coarse.IgnoreUncovered();
        List<PlanePoint> way = WayAnnealer.Anneal(
            _region, coarse, _width, Way, _from, 1, FineFrom, (long)(maxEffort * CoarsePart), seed);
        way = WayAnnealer.Anneal(
            _region, _samples, _width, way, _from, FineFrom, 0, (long)(maxEffort * (1 - CoarsePart)), seed + 1);
        way = WayShortener.Shorten(_region, _samples, _width, way, maxEffort / 10);
        if (Cost(way) < Cost(Way))
            Way = way;
        return this;
    }

    /// <summary>Moves the corners of the way, or leaves them out, as long as that makes it shorter.</summary>
    public Draft Shortened(long maxEffort)
    {
        Way = WayShortener.Shorten(_region, _samples, _width, Way, maxEffort);
        return this;
    }

    /// <summary>Closes the gaps between the samples; in the last rounds only by ways there and back.</summary>
    public Draft Closed(long maxEffort)
    {
        List<PlanePoint> way = Way;
        for (int round = 0; round < MaxRounds; round++)
        {
            List<PlanePoint> gaps = CoverageGaps.Find(_region, way, _sweep / 2);
            if (gaps.Count == 0)
                break;
            _samples.Add(gaps);
            bool isLast = round >= MaxRounds - 3;
            Close(way, gaps, onlyAdds: isLast);
            if (!isLast)
                way = WayShortener.Shorten(_region, _samples, _width, way, maxEffort);
        }

        Way = way;
        return this;
    }

    /// <summary>Length of the way, with what its corners cost, metres.</summary>
    public double Length => Cost(Way);

    /// <summary>Whether all of the way is where the vehicle may be.</summary>
    public bool IsFree => Way.All(_region.IsFree)
        && Enumerable.Range(0, Way.Count - 1).All(i => _region.IsFree(Way[i], Way[i + 1]));

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

    private double Cost(List<PlanePoint> way) => WayShortener.Cost(way, _sweep, _from);

    // Rounding.
    private static double Radius(double width) => (width / 2) + 1e-6;

    // Gaps between the samples are closed by a way over there from the nearest leg.
    private void Close(List<PlanePoint> way, List<PlanePoint> gaps, bool onlyAdds)
    {
        _samples.Clear();
        for (int i = 0; i < Math.Max(1, way.Count - 1); i++)
            _samples.Change(way[i], way[Math.Min(i + 1, way.Count - 1)], 1);
        double radius = Radius(_width) * (1 - CoverageGaps.Resolution);
        var rest = gaps.ToList();
        while (rest.Count > 0)
        {
            PlanePoint p = rest[0];
            rest.RemoveAt(0);
            if (TryReach(p, way, onlyAdds))
                rest.RemoveAll(r => DistanceTo(way, r) <= radius);
        }

        _samples.IgnoreUncovered();
    }

    private bool TryReach(PlanePoint p, List<PlanePoint> way, bool onlyAdds)
    {
        int leg = Enumerable.Range(0, Math.Max(1, way.Count - 1))
            .OrderBy(i => PlanePolygon.DistanceToSegment(p, way[i], way[Math.Min(i + 1, way.Count - 1)])).First();
        PlanePoint at = PlanePolygon.NearestOfSegment(p, way[leg], way[Math.Min(leg + 1, way.Count - 1)]);
        double distance = p.DistanceTo(at);
        PlanePoint step = (distance - (0.99 * _width / 2)) / distance * (p - at);
        if (!onlyAdds && TryBend(way, leg, at, step))
            return true;
        foreach (PlanePoint there in Around(p, Radius(_width)).Prepend(at + step))
        {
            if (!_region.IsFree(there) || _region.PathBetween(at, there) is not { } path)
                continue;
            Replace(way, leg, Math.Min(2, way.Count - leg),
                [way[leg], at, .. path, there, .. Enumerable.Reverse(path), at, way[Math.Min(leg + 1, way.Count - 1)]]);
            return true;
        }

        return false;
    }

    // The shortest of the changes of a leg by which it comes nearer to a place without uncovering anything.
    private bool TryBend(List<PlanePoint> way, int leg, PlanePoint at, PlanePoint step)
    {
        if (leg + 1 >= way.Count)
            return false;
        (PlanePoint a, PlanePoint b) = (way[leg], way[leg + 1]);
        double part = a.DistanceTo(at) / Math.Max(1e-9, a.DistanceTo(b));
        var changes = new List<(int At, int Count, List<PlanePoint> By)>
        {
            (leg, 2, [a + step, b + step]), (leg, 2, [a, at + step, b]),
        };
        if (part < 0.8)
            changes.Add((leg, 1, [a + (1 / (1 - part) * step)]));
        if (part > 0.2)
            changes.Add((leg + 1, 1, [b + (1 / part * step)]));
        foreach ((int first, int count, List<PlanePoint> by) in changes)
        {
            if (first > 0)
                by.Insert(0, way[first - 1]);
            if (first + count < way.Count)
                by.Add(way[first + count]);
        }

        foreach ((int first, int count, List<PlanePoint> by) in changes.OrderBy(c => More(way, c.At, c.Count, c.By)))
        {
            int from = Math.Max(0, first - 1);
            int old = Math.Min(way.Count, first + count + 1) - from;
            bool isFree = by.All(_region.IsFree)
                && Enumerable.Range(0, by.Count - 1).All(i => _region.IsFree(by[i], by[i + 1]));
            if (!isFree || !_samples.CanReplace(way.GetRange(from, old), by))
                continue;
            Replace(way, from, old, by);
            return true;
        }

        return false;
    }

    private static double DistanceTo(List<PlanePoint> way, PlanePoint p)
    {
        double least = p.DistanceTo(way[0]);
        for (int i = 0; i + 1 < way.Count; i++)
            least = Math.Min(least, PlanePolygon.DistanceToSegment(p, way[i], way[i + 1]));
        return least;
    }

    private static double More(List<PlanePoint> way, int first, int count, List<PlanePoint> by)
    {
        int from = Math.Max(0, first - 1);
        return WayShortener.Length(by)
            - WayShortener.Length(way.GetRange(from, Math.Min(way.Count, first + count + 1) - from));
    }

    private void Replace(List<PlanePoint> way, int from, int count, List<PlanePoint> by)
    {
        for (int i = 0; i + 1 < by.Count; i++)
            _samples.Change(by[i], by[i + 1], 1);
        for (int i = from; i + 1 < from + count; i++)
            _samples.Change(way[i], way[i + 1], -1);
        way.RemoveRange(from, count);
        way.InsertRange(from, by);
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
