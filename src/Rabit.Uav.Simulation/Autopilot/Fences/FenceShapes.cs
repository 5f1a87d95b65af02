using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Polygons and circles of an uploaded fence, metres in the world. A place is inside if it is in all that include and
/// in none that excludes.
/// </summary>
internal sealed class FenceShapes
{
    private const double RadiansPerDegE7 = NedMath.RadiansPerDegree * 1e-7;
    private const int MinVertices = 3;

    private readonly List<Shape> _shapes = [];

    private FenceShapes()
    {
    }

    public static FenceShapes None { get; } = new();

    public int Count => _shapes.Count;

    /// <summary>
    /// Makes the shapes of a list of items; false where the vertices of a polygon are fewer or more than they say, or
    /// others come in between.
    /// </summary>
    public static bool TryCreate(IReadOnlyList<MissionItemInt> items, WorldFrame frame, out FenceShapes shapes)
    {
        shapes = new FenceShapes();
        for (int index = 0; index < items.Count;)
        {
            MissionItemInt item = items[index];
            bool includes = item.Command is MavCmd.NavFencePolygonVertexInclusion or MavCmd.NavFenceCircleInclusion;
            if (item.Command is MavCmd.NavFenceCircleInclusion or MavCmd.NavFenceCircleExclusion)
            {
                shapes._shapes.Add(new Shape([PlaceOf(item, frame)], item.Param1, includes));
                index++;
            }
            else if (item.Command == MavCmd.NavFenceReturnPoint)
            {
                index++;
            }
            else
            {
                int count = (int)item.Param1;
                if (!IsPolygon(items, index, count))
                    return false;
                var corners = new NedVector[count];
                for (int corner = 0; corner < count; corner++)
                    corners[corner] = PlaceOf(items[index + corner], frame);
                shapes._shapes.Add(new Shape(corners, 0, includes));
                index += count;
            }
        }

        return true;
    }

    /// <summary>How far outside a place is at most, metres; negative: it is inside, by so much at least.</summary>
    public double MetresOutside(NedVector place)
    {
        double most = double.NegativeInfinity;
        foreach (Shape shape in _shapes)
            most = Math.Max(most, shape.MetresOutside(place));
        return most;
    }

    private static bool IsPolygon(IReadOnlyList<MissionItemInt> items, int first, int count)
    {
        if (count < MinVertices || first + count > items.Count)
            return false;
        for (int index = first; index < first + count; index++)
        {
            if (items[index].Command != items[first].Command || !items[index].Param1.Equals(items[first].Param1))
                return false;
        }

        return true;
    }

    private static NedVector PlaceOf(in MissionItemInt item, WorldFrame frame)
        => frame.ToWorld(GeodeticPosition.FromRadians(
            item.X * RadiansPerDegE7, item.Y * RadiansPerDegE7, frame.Origin.AltitudeAmslMetres));

    /// <summary>A polygon, or a circle where there is one corner.</summary>
    private sealed class Shape(NedVector[] corners, double radius, bool includes)
    {
        public double MetresOutside(NedVector place)
        {
            double outside = corners.Length == 1
                ? place.Minus(corners[0]).HorizontalLength() - radius
                : OutsidePolygon(place);
            return includes ? outside : -outside;
        }

        private double OutsidePolygon(NedVector place)
        {
            double nearest = double.MaxValue;
            bool isInside = false;
            for (int index = 0; index < corners.Length; index++)
            {
                NedVector a = corners[index];
                NedVector b = corners[(index + 1) % corners.Length];
                if ((a.North > place.North) != (b.North > place.North)
                    && place.East < ((b.East - a.East) * (place.North - a.North) / (b.North - a.North)) + a.East)
                {
                    isInside = !isInside;
                }

                nearest = Math.Min(nearest, Distance(place, a, b));
            }

            return isInside ? -nearest : nearest;
        }

        private static double Distance(NedVector place, NedVector a, NedVector b)
        {
            NedVector side = b.Minus(a);
            NedVector there = place.Minus(a);
            double length = (side.North * side.North) + (side.East * side.East);
            double part = length > 0
                ? NedMath.Limited(((there.North * side.North) + (there.East * side.East)) / length, 0, 1)
                : 0;
            return there.Minus(side.Times(part)).HorizontalLength();
        }
    }
}
