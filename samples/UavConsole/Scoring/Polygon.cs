using System;
using System.Collections.Generic;
using Rabit.Geodesy;

namespace UavConsole;

/// <summary>An area on the ground: corners in order, in a local frame, metres.</summary>
internal sealed class Polygon(IReadOnlyList<NedPosition> corners)
{
    /// <summary>How far a point is from the area, horizontally; 0 inside and on the edge.</summary>
    public double MetresOutside(NedPosition point)
    {
        bool isInside = false;
        double nearest = double.PositiveInfinity;
        for (int index = 0; index < corners.Count; index++)
        {
            NedPosition a = corners[index];
            NedPosition b = corners[(index + 1) % corners.Count];
            if ((a.North > point.North) != (b.North > point.North)
                && point.East < a.East + ((b.East - a.East) * (point.North - a.North) / (b.North - a.North)))
                isInside = !isInside;
            nearest = Math.Min(nearest, DistanceToEdge(point, a, b));
        }

        return isInside ? 0 : nearest;
    }

    private static double DistanceToEdge(NedPosition p, NedPosition a, NedPosition b)
    {
        double north = b.North - a.North;
        double east = b.East - a.East;
        double length = (north * north) + (east * east);
        double along = length > 0 ? (((p.North - a.North) * north) + ((p.East - a.East) * east)) / length : 0;
        along = Math.Max(0, Math.Min(1, along));
        double offNorth = p.North - a.North - (along * north);
        double offEast = p.East - a.East - (along * east);
        return Math.Sqrt((offNorth * offNorth) + (offEast * offEast));
    }
}
