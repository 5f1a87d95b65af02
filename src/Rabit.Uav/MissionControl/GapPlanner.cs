using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Legs over the gaps in the coverage, the ground that the lanes missed: narrow strips through what is left, so that
/// each leg is flown over its middle.
/// </summary>
internal static class GapPlanner
{
    // Less than this is a few cells at the border, left by rounding.
    private const double MinGapSquareMetres = 6;

    /// <summary>Legs in the order in which they are flown, each from its nearer end.</summary>
    /// <param name="unseen">Centres of the cells that were not seen.</param>
    /// <param name="cellMetres">Side of a cell.</param>
    /// <param name="spacingMetres">Width of the strip that one leg covers.</param>
    /// <param name="headingRadians">Direction of the legs.</param>
    /// <param name="from">Where the vehicle is.</param>
    public static List<LaneSegment> Plan(
        IEnumerable<PlanePoint> unseen, double cellMetres, double spacingMetres, double headingRadians, PlanePoint from)
    {
        PlanePoint along = PlanePoint.Towards(headingRadians);
        var right = new PlanePoint(-along.East, along.North);
        (double Offset, double Along)[] cells = unseen
            .Select(c => (Offset: c.Dot(right), Along: c.Dot(along))).OrderBy(c => c.Offset).ToArray();
        var legs = new List<LaneSegment>();
        for (int first = 0; first < cells.Length;)
        {
            double edge = cells[first].Offset + spacingMetres;
            int next = first;
            while (next < cells.Length && cells[next].Offset < edge)
                next++;
            legs.AddRange(LegsOf(cells.Skip(first).Take(next - first).ToList(), along, cellMetres, spacingMetres));
            first = next;
        }

        return NearestFirst(legs, from);
    }

    private static IEnumerable<LaneSegment> LegsOf(
        List<(double Offset, double Along)> strip, PlanePoint along, double cell, double spacing)
    {
        IEnumerable<(double, double)> intervals = strip.Select(c => (c.Along - (cell / 2), c.Along + (cell / 2)));
        foreach ((double from, double to) in LanePlanner.Join(intervals, gap: spacing / 2))
        {
            List<double> offsets = strip.Where(c => c.Along > from && c.Along < to).Select(c => c.Offset).ToList();
            if (offsets.Count * cell * cell >= MinGapSquareMetres)
                yield return LanePlanner.Segment(along, (offsets.Min() + offsets.Max()) / 2, from, to);
        }
    }

    private static List<LaneSegment> NearestFirst(List<LaneSegment> legs, PlanePoint from)
    {
        var ordered = new List<LaneSegment>();
        while (legs.Count > 0)
        {
            int nearest = Enumerable.Range(0, legs.Count)
                .OrderBy(i => System.Math.Min(from.DistanceTo(legs[i].Start), from.DistanceTo(legs[i].End))).First();
            LaneSegment leg = legs[nearest];
            legs.RemoveAt(nearest);
            if (from.DistanceTo(leg.End) < from.DistanceTo(leg.Start))
                leg = new LaneSegment(leg.End, leg.Start);
            ordered.Add(leg);
            from = leg.End;
        }

        return ordered;
    }
}
