using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Leaves out lanes whose ground is seen from the lanes beside them: from a layer above the height of the mission a
/// camera sees more than the strip of one lane. Stateless.
/// </summary>
internal static class LaneThinning
{
    /// <summary>By how much a picture is moved sideways by roll, and the vehicle by wind: part of the height.</summary>
    public const double SwayFraction = 0.06;

    /// <summary>How many lanes each pass of a vehicle is for.</summary>
    /// <param name="seenToEachSideMetres">How far it sees to each side; 0 where that is not known.</param>
    /// <param name="spacingMetres">From one lane to the next.</param>
    public static int LanesPerPass(double seenToEachSideMetres, double spacingMetres)
        => Math.Max(1, (int)Math.Floor(2 * seenToEachSideMetres / spacingMetres));

    /// <summary>The legs that are to be flown, in their order.</summary>
    /// <param name="legs">All of them.</param>
    /// <param name="acrossHeadingRadians">The direction across the lanes.</param>
    /// <param name="halfMetres">How far the strip of a leg goes to each side.</param>
    /// <param name="seenToEachSideMetres">How far the camera sees.</param>
    /// <param name="cellMetres">From one place that is looked at to the next.</param>
    /// <param name="isWanted">Whether a place is still to be seen.</param>
    public static List<LaneSegment> Thin(
        IReadOnlyList<LaneSegment> legs, double acrossHeadingRadians, double halfMetres, double seenToEachSideMetres,
        double cellMetres, Func<PlanePoint, bool> isWanted)
    {
        PlanePoint across = PlanePoint.Towards(acrossHeadingRadians);
        var kept = legs.ToList();
        var leftOut = new List<LaneSegment>();
        foreach (LaneSegment leg in legs.OrderBy(l => across.Dot(l.Start + l.End)))
        {
            int at = kept.IndexOf(leg);
            LaneSegment[] near = kept.Where((_, i) => i != at)
                .Where(l => IsNear(l, leg, 2 * (seenToEachSideMetres + halfMetres))).ToArray();

            // What was left out may have been to be seen from this one.
            bool isSeen = leftOut.Where(l => IsNear(l, leg, seenToEachSideMetres + halfMetres)).Append(leg)
                .All(l => PlacesOf(l, halfMetres, cellMetres).All(p => !isWanted(p) || IsSeen(p, near)));
            if (!isSeen)
                continue;
            kept.RemoveAt(at);
            leftOut.Add(leg);
        }

        return kept;

        bool IsSeen(PlanePoint place, LaneSegment[] from)
            => from.Any(l => l.DistanceTo(place) <= seenToEachSideMetres);
    }

    private static bool IsNear(LaneSegment a, LaneSegment b, double metres)
        => a.DistanceTo(b.Start) <= metres || a.DistanceTo(b.End) <= metres
            || b.DistanceTo(a.Start) <= metres || b.DistanceTo(a.End) <= metres;

    private static IEnumerable<PlanePoint> PlacesOf(LaneSegment leg, double halfMetres, double cellMetres)
    {
        PlanePoint along = (1 / leg.Length) * (leg.End - leg.Start);
        var right = new PlanePoint(-along.East, along.North);
        for (double at = 0; at <= leg.Length; at += 2 * cellMetres)
        {
            for (double side = -halfMetres + (cellMetres / 2); side < halfMetres; side += cellMetres)
                yield return leg.Start + (at * along) + (side * right);
        }
    }
}
