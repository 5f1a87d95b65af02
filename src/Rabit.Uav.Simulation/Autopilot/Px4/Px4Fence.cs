using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The geofence: polygons and circles as they were uploaded, and the distance and height from home that the parameters
/// give.
/// </summary>
internal sealed class Px4Fence(WorldFrame frame)
{
    private readonly List<Area> _areas = [];

    /// <summary>Whether items are a fence.</summary>
    public bool IsFence(IReadOnlyList<MissionItemInt> items) => TryRead(items, out _);

    /// <summary>Takes uploaded items; false where they are no fence, which changes nothing.</summary>
    public bool TrySet(IReadOnlyList<MissionItemInt> items)
    {
        if (!TryRead(items, out List<Area> areas))
            return false;
        _areas.Clear();
        _areas.AddRange(areas);
        return true;
    }

    private bool TryRead(IReadOnlyList<MissionItemInt> items, out List<Area> areas)
    {
        areas = [];
        for (int index = 0; index < items.Count;)
        {
            MissionItemInt item = items[index];
            bool isPolygon = item.Command is MavCmd.NavFencePolygonVertexInclusion
                or MavCmd.NavFencePolygonVertexExclusion;
            bool isCircle = item.Command is MavCmd.NavFenceCircleInclusion or MavCmd.NavFenceCircleExclusion;
            bool isInside = item.Command is MavCmd.NavFencePolygonVertexInclusion or MavCmd.NavFenceCircleInclusion;
            int corners = isPolygon ? (int)item.Param1 : 1;
            if ((!isPolygon && !isCircle) || (isPolygon && corners < 3) || corners > items.Count - index)
                return false;
            var points = new List<NedVector>();
            for (int corner = 0; corner < corners; corner++)
                points.Add(Place(items[index + corner]));
            areas.Add(new Area(points, isCircle ? item.Param1 : 0, isInside));
            index += corners;
        }

        return true;
    }

    public bool IsBreached(Px4Situation situation)
    {
        NedVector home = situation.Home ?? default;
        double distance = situation.Parameters.FenceDistance.Value;
        double height = situation.Parameters.FenceHeight.Value;
        if (distance > 0 && home.Minus(situation.Position).HorizontalLength() > distance)
            return true;
        if (height > 0 && situation.Height > height)
            return true;
        bool hasInclusion = false;
        bool isIncluded = false;
        foreach (Area area in _areas)
        {
            bool contains = area.Contains(situation.Position);
            if (!area.IsInclusion && contains)
                return true;
            hasInclusion |= area.IsInclusion;
            isIncluded |= area.IsInclusion && contains;
        }

        return hasInclusion && !isIncluded;
    }

    private NedVector Place(in MissionItemInt item)
    {
        const double RadiansPerDegE7 = NedMath.RadiansPerDegree * 1e-7;
        return frame.ToWorld(GeodeticPosition.FromRadians(
            item.X * RadiansPerDegE7, item.Y * RadiansPerDegE7, frame.Origin.AltitudeAmslMetres));
    }

    private sealed class Area(List<NedVector> points, double radius, bool isInclusion)
    {
        public bool IsInclusion { get; } = isInclusion;

        public bool Contains(NedVector place)
        {
            if (radius > 0)
                return points[0].Minus(place).HorizontalLength() <= radius;
            bool isInside = false;
            for (int index = 0, last = points.Count - 1; index < points.Count; last = index++)
            {
                (NedVector a, NedVector b) = (points[index], points[last]);
                bool crosses = (a.North > place.North) != (b.North > place.North);
                if (crosses
                    && place.East < ((b.East - a.East) * (place.North - a.North) / (b.North - a.North)) + a.East)
                {
                    isInside = !isInside;
                }
            }

            return isInside;
        }
    }
}
