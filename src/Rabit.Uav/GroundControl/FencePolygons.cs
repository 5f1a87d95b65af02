using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.GroundControl;

/// <summary>The polygons of a fence: one to be inside of, any number to stay out of.</summary>
internal static class FencePolygons
{
    private const double DegreesPerUnit = 1e-7;
    private const int MaxLatitude = 900_000_000;
    private const int MaxLongitude = 1_800_000_000;

    /// <summary>Whether an item is a corner of a polygon in one of the global frames.</summary>
    public static MavMissionResult Check(in MissionItemInt item)
    {
        if (item.Command is not (MavCmd.NavFencePolygonVertexInclusion or MavCmd.NavFencePolygonVertexExclusion))
            return MavMissionResult.Unsupported;
        if (item.Frame is not (MavFrame.Global or MavFrame.GlobalInt or MavFrame.GlobalRelativeAlt
            or MavFrame.GlobalRelativeAltInt))
            return MavMissionResult.UnsupportedFrame;
        if (item.X is < -MaxLatitude or > MaxLatitude)
            return MavMissionResult.InvalidParam5X;
        if (item.Y is < -MaxLongitude or > MaxLongitude)
            return MavMissionResult.InvalidParam6Y;

        // Comparisons with NaN are false.
        return item.Param1 >= 3 && item.Param1 <= ushort.MaxValue
            ? MavMissionResult.Accepted
            : MavMissionResult.InvalidParam1;
    }

    /// <summary>Reads the items of a fence that were checked one by one.</summary>
    /// <returns>What is wrong with them; null where nothing is.</returns>
    public static string? TryRead(
        ReadOnlySpan<MissionItemInt> items, out ImmutableArray<GeodeticPosition> area,
        out ImmutableArray<ImmutableArray<GeodeticPosition>> keepOuts)
    {
        (area, keepOuts) = ([], []);
        var outside = new List<ImmutableArray<GeodeticPosition>>();
        int inclusions = 0;
        for (int first = 0; first < items.Length;)
        {
            int count = (int)items[first].Param1;
            if (first + count > items.Length)
                return "a polygon has fewer corners than it says";
            var corners = ImmutableArray.CreateBuilder<GeodeticPosition>(count);
            for (int i = first; i < first + count; i++)
            {
                if (items[i].Command != items[first].Command || !items[i].Param1.Equals(items[first].Param1))
                    return "a polygon has fewer corners than it says";
                corners.Add(GeodeticPosition.FromDegrees(items[i].X * DegreesPerUnit, items[i].Y * DegreesPerUnit, 0));
            }

            if (items[first].Command == MavCmd.NavFencePolygonVertexInclusion)
                (area, inclusions) = (corners.MoveToImmutable(), inclusions + 1);
            else
                outside.Add(corners.MoveToImmutable());
            first += count;
        }

        keepOuts = outside.ToImmutableArray();
        return inclusions == 1
            ? null
            : FormattableString.Invariant($"there are {inclusions} inclusion polygons; one is searched");
    }
}
