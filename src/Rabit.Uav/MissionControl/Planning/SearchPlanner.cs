using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Plans the legs that cover a region, and their order: parallel lanes in several directions, and rings in a convex
/// area; the shortest ways are shortened further. Deterministic, in bounded time.
/// </summary>
internal static class SearchPlanner
{
    // Planned a little narrower than the sweep, by more than CoverageGaps resolves.
    public const double SweepMargin = 0.994;

    private const double HeadingStepRadians = Math.PI / 18;
    private const int MaxHeadings = 6;
    private const int MaxTrimmed = 6;
    private const ulong Seed = 7;
    private const int MaxAnnealed = 2;

    // Pictures that the headings that are tried may have together, and how many samples may be looked at: to shorten
    // each of the ways, and to anneal each of the best of them.
    private const double MaxSquares = 2500;

    // In a larger area the samples are too far apart to shorten long legs by them without leaving gaps, which then take
    // longer to close than the way has gained.
    private const double MaxShortenedSquares = 600;
    private const long MaxEffort = 6_000_000;
    private const long AnnealEffort = 60_000_000;

    /// <summary>The way; null where a part cannot be reached from the rest.</summary>
    /// <param name="outer">The outer border.</param>
    /// <param name="keepOuts">Where it may not fly.</param>
    /// <param name="clearance">Distance from these, metres.</param>
    /// <param name="sweep">Width of the ground that is seen, half of it on either side of the way, metres.</param>
    /// <param name="heading">Direction of the lanes, radians; null for the one with the shortest way.</param>
    /// <param name="from">Where the vehicle is; null where the way may begin anywhere.</param>
    /// <param name="isQuick">Whether the way need not be the shortest: a vehicle that flies waits for it.</param>
    public static SearchWay? Plan(
        PlanePolygon outer, IReadOnlyList<PlanePolygon> keepOuts, double clearance, double sweep, double? heading,
        PlanePoint? from, bool isQuick = false)
    {
        var region = new SearchRegion(outer, keepOuts, clearance);
        double squares = region.Outer.Area / sweep / sweep;
        bool isLarge = squares > MaxShortenedSquares;
        int headings = (int)Math.Max(1, Math.Min(MaxHeadings, MaxSquares / squares));
        var patterns = new List<(List<List<PlanePoint>> Lanes, double Heading, double Width)>();
        foreach (double h in heading is { } given ? [given] : Headings(region, sweep).Take(headings))
        {
            List<List<PlanePoint>> lanes = LaneCutter.Cut(region, SweepMargin * sweep, h, out _);
            patterns.Add((lanes, h, SweepMargin * sweep));
        }

        if (heading is null && region.IsConvex && !isLarge)
        {
            double width = SweepMargin * sweep;
            patterns.Add((ContourCutter.Cut(region.Outer, width, isEven: true), 0, width));
            patterns.Add((ContourCutter.Cut(region.Outer, width, isEven: false), 0, width));
        }

        Draft[] drafts = patterns.Select(p => Draft.Of(region, sweep, p.Width, p.Lanes, p.Heading, from))
            .OfType<Draft>().OrderBy(d => d.Length).Take(isQuick ? MaxTrimmed / 2 : MaxTrimmed)
            .Select(d => isLarge ? d.Trimmed() : d.Trimmed().Shortened(MaxEffort)).OrderBy(d => d.Length)
            .Take(isQuick ? 1 : Math.Min(headings, MaxAnnealed)).ToArray();
        for (int i = 0; i < drafts.Length; i++)
        {
            if (!isQuick && !isLarge)
                drafts[i].Annealed(AnnealEffort, Seed + (ulong)i);
            drafts[i].Closed(MaxEffort / 4);
        }

        return drafts.Where(d => d.IsFree).OrderBy(d => d.Length).FirstOrDefault()?.ToWay();
    }

    /// <summary>How much of a way is outside an area.</summary>
    public static double OutsideFraction(PlanePolygon area, IReadOnlyList<PlanePoint> way)
    {
        double outside = 0;
        double length = 0;
        for (int i = 0; i + 1 < way.Count; i++)
        {
            List<double> cuts = area.CrossingsOf(way[i], way[i + 1]);
            length += way[i].DistanceTo(way[i + 1]);
            for (int k = 0; k + 1 < cuts.Count; k++)
            {
                PlanePoint middle = way[i] + ((cuts[k] + cuts[k + 1]) / 2 * (way[i + 1] - way[i]));
                if (area.SignedDistance(middle) < -0.01)
                    outside += (cuts[k + 1] - cuts[k]) * way[i].DistanceTo(way[i + 1]);
            }
        }

        return outside / Math.Max(1, length);
    }

    // Those of the edges and some more, the most promising first.
    private static IEnumerable<double> Headings(SearchRegion region, double spacing)
        => region.KeepOuts.Concat([region.Outer])
            .SelectMany(p => Enumerable.Range(0, p.Corners.Count)
                .Select(i => (p.After(i) - p.Corners[i]).HeadingRadians))
            .Concat(Enumerable.Range(0, (int)(Math.PI / HeadingStepRadians)).Select(i => i * HeadingStepRadians))
            .Select(h => h - (Math.Floor(h / Math.PI) * Math.PI))
            .GroupBy(h => Math.Round(h, 2)).Select(g => g.First())
            .OrderBy(h => Estimate(region, spacing, h));

    private static double Estimate(SearchRegion region, double spacing, double heading)
    {
        List<List<PlanePoint>> lanes = LaneCutter.Cut(region, spacing, heading, out _);
        double sum = spacing * lanes.Count;
        foreach (List<PlanePoint> lane in lanes)
        {
            for (int i = 0; i + 1 < lane.Count; i++)
                sum += lane[i].DistanceTo(lane[i + 1]);
        }

        return sum;
    }
}
