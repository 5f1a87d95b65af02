using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Plans parallel survey lines (lanes, transects) over an area, flown to and fro: a lawnmower, or boustrophedon,
/// pattern. Each lane covers a strip half a spacing to either side and is as long as the area is anywhere in its strip;
/// in a concave area a lane has several segments.
/// </summary>
internal static class LanePlanner
{
    // Segments nearer to each other than this part of a spacing are joined: flying around the gap would take longer.
    private const double JoinedGapInSpacings = 1;

    // A shorter segment is made this long: a point has no heading to fly along.
    private const double MinSegmentMetres = 4;

    /// <summary>
    /// The lanes in the order in which they are flown; the first begins at the end nearest to the vehicle.
    /// </summary>
    /// <param name="area">The area; its edges do not cross.</param>
    /// <param name="spacingMetres">
    /// Maximum distance between lanes; it is reduced so that all strips are equally wide.
    /// </param>
    /// <param name="headingRadians">Direction of the lanes; null for the one that needs the fewest.</param>
    /// <param name="from">Where the vehicle is.</param>
    public static IReadOnlyList<LaneSegment> Plan(
        PlanePolygon area, double spacingMetres, double? headingRadians, PlanePoint from)
    {
        double heading = headingRadians ?? BestHeading(area, spacingMetres);
        List<List<LaneSegment>> lanes = Lanes(area, spacingMetres, heading);
        return Orders(lanes).OrderBy(order => from.DistanceTo(order[0].Start)).First();
    }

    /// <summary>The direction that needs the fewest lanes; among equals the one with the shortest path.</summary>
    public static double BestHeading(PlanePolygon area, double spacingMetres)
    {
        PlanePolygon hull = PlanePolygon.HullOf(area.Corners);
        return Enumerable.Range(0, hull.Corners.Count)
            .Select(i => (hull.After(i) - hull.Corners[i]).HeadingRadians)
            .OrderBy(heading => LaneCount(area, spacingMetres, heading))
            .ThenBy(heading => Math.Round(Lanes(area, spacingMetres, heading).Sum(lane => lane.Sum(s => s.Length)), 3))
            .First();
    }

    /// <summary>The part of a strip that an area fills: intervals along it that do not overlap, in order.</summary>
    /// <param name="area">The area.</param>
    /// <param name="along">Unit vector along the strip.</param>
    /// <param name="from">Where the strip begins, to the right of the origin, metres.</param>
    /// <param name="to">Where it ends.</param>
    public static List<(double From, double To)> Extents(PlanePolygon area, PlanePoint along, double from, double to)
    {
        var right = new PlanePoint(-along.East, along.North);
        double[] cuts = area.Corners.Select(c => c.Dot(right)).Where(o => o > from && o < to)
            .Concat([from, to]).OrderBy(o => o).ToArray();
        var extents = new List<(double From, double To)>();
        for (int i = 0; i + 1 < cuts.Length; i++)
        {
            if (cuts[i + 1] - cuts[i] > 1e-9)
                extents.AddRange(Trapezoids(area, along, right, cuts[i], cuts[i + 1]));
        }

        return Join(extents, gap: 0);
    }

    /// <summary>Intervals in order; those that overlap or are nearer to each other than a gap are joined.</summary>
    public static List<(double From, double To)> Join(IEnumerable<(double From, double To)> intervals, double gap)
    {
        var joined = new List<(double From, double To)>();
        foreach ((double from, double to) in intervals.OrderBy(x => x.From))
        {
            int last = joined.Count - 1;
            if (last >= 0 && from <= joined[last].To + gap)
                joined[last] = (joined[last].From, Math.Max(joined[last].To, to));
            else
                joined.Add((from, to));
        }

        return joined;
    }

    /// <summary>A segment along a line; one that is too short to have a heading is lengthened.</summary>
    public static LaneSegment Segment(PlanePoint along, double offset, double from, double to)
    {
        var right = new PlanePoint(-along.East, along.North);
        double missing = Math.Max(0, MinSegmentMetres - (to - from)) / 2;
        return new LaneSegment(
            ((from - missing) * along) + (offset * right), ((to + missing) * along) + (offset * right));
    }

    private static int LaneCount(PlanePolygon area, double spacing, double heading)
    {
        (double from, double to) = Width(area, heading);

        // A width that is a whole number of spacings but for rounding needs no additional lane.
        return Math.Max(1, (int)Math.Ceiling(((to - from) / spacing) - 1e-6));
    }

    private static (double From, double To) Width(PlanePolygon area, double heading)
    {
        PlanePoint along = PlanePoint.Towards(heading);
        var right = new PlanePoint(-along.East, along.North);
        return (area.Corners.Min(c => c.Dot(right)), area.Corners.Max(c => c.Dot(right)));
    }

    private static List<List<LaneSegment>> Lanes(PlanePolygon area, double spacing, double heading)
    {
        PlanePoint along = PlanePoint.Towards(heading);
        (double from, double to) = Width(area, heading);
        int count = LaneCount(area, spacing, heading);
        double strip = (to - from) / count;
        return Enumerable.Range(0, count)
            .Select(i => Join(
                Extents(area, along, from + (i * strip), from + ((i + 1) * strip)), JoinedGapInSpacings * spacing)
                .Select(x => Segment(along, from + ((i + 0.5) * strip), x.From, x.To)).ToList())
            .Where(segments => segments.Count > 0)
            .ToList();
    }

    // From the left or from the right, the first lane forwards or backwards.
    private static IEnumerable<List<LaneSegment>> Orders(List<List<LaneSegment>> lanes)
    {
        foreach (IEnumerable<List<LaneSegment>> order in new[] { lanes, Enumerable.Reverse(lanes) })
        {
            yield return Boustrophedon(order, firstIsReversed: false);
            yield return Boustrophedon(order, firstIsReversed: true);
        }
    }

    private static List<LaneSegment> Boustrophedon(IEnumerable<List<LaneSegment>> lanes, bool firstIsReversed)
        => lanes.SelectMany((lane, i) => (i % 2 == 1) != firstIsReversed
            ? Enumerable.Reverse(lane).Select(p => new LaneSegment(p.End, p.Start))
            : lane).ToList();

    // No corner lies between two cuts: the edges that cross the strip come in pairs and bound trapezoids (trapezoidal
    // decomposition).
    private static IEnumerable<(double From, double To)> Trapezoids(
        PlanePolygon area, PlanePoint along, PlanePoint right, double low, double high)
    {
        var edges = new List<(double AtLow, double AtHigh)>();
        for (int i = 0; i < area.Corners.Count; i++)
        {
            PlanePoint a = area.Corners[i];
            PlanePoint b = area.After(i);
            double oa = a.Dot(right);
            double ob = b.Dot(right);
            if (Math.Min(oa, ob) <= low + 1e-9 && Math.Max(oa, ob) >= high - 1e-9 && Math.Abs(ob - oa) > 1e-9)
                edges.Add((AlongAt(low), AlongAt(high)));

            double AlongAt(double offset) => a.Dot(along) + ((b.Dot(along) - a.Dot(along)) * (offset - oa) / (ob - oa));
        }

        edges.Sort((x, y) => (x.AtLow + x.AtHigh).CompareTo(y.AtLow + y.AtHigh));
        for (int i = 0; i + 1 < edges.Count; i += 2)
            yield return (Math.Min(edges[i].AtLow, edges[i].AtHigh), Math.Max(edges[i + 1].AtLow, edges[i + 1].AtHigh));
    }
}
