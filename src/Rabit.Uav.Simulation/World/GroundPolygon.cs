using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.Simulation;

/// <summary>
/// An area of the ground by its corners, convex or not, any winding, metres north and east. On purpose not the
/// polygon of Mission Control: an error in that one must not be repeated in the world that it is tested in.
/// Immutable.
/// </summary>
internal sealed class GroundPolygon
{
    private readonly (double North, double East)[] _corners;

    /// <exception cref="ArgumentException">Fewer than three corners, or one that is no place.</exception>
    public GroundPolygon(IReadOnlyList<(double North, double East)> corners, string parameter)
    {
        _corners = (corners ?? throw new ArgumentNullException(parameter)).ToArray();
        if (_corners.Length < 3)
            throw new ArgumentException($"An area needs at least 3 corners; it has {_corners.Length}.", parameter);
        int bad = Array.FindIndex(_corners, c => !IsFinite(c.North) || !IsFinite(c.East));
        if (bad >= 0)
            throw new ArgumentException(
                $"Corner {bad + 1} of the area is not a finite position: {_corners[bad].North} north, "
                    + $"{_corners[bad].East} east.",
                parameter);
        (South, North) = (_corners.Min(c => c.North), _corners.Max(c => c.North));
        (West, East) = (_corners.Min(c => c.East), _corners.Max(c => c.East));
    }

    public double South { get; }

    public double North { get; }

    public double West { get; }

    public double East { get; }

    /// <summary>
    /// Whether a place is inside: a line from it to the east crosses the edges an odd number of times.
    /// </summary>
    public bool Contains(double north, double east)
    {
        bool isInside = false;
        for (int i = 0, j = _corners.Length - 1; i < _corners.Length; j = i++)
        {
            (double n1, double e1) = _corners[i];
            (double n2, double e2) = _corners[j];
            if (n1 > north != n2 > north && east < e1 + ((e2 - e1) * (north - n1) / (n2 - n1)))
                isInside = !isInside;
        }

        return isInside;
    }

    /// <summary>How far a place is from the nearest edge, inside or outside.</summary>
    public double DistanceToEdge(double north, double east)
    {
        double best = double.PositiveInfinity;
        for (int i = 0, j = _corners.Length - 1; i < _corners.Length; j = i++)
        {
            (double alongNorth, double alongEast) =
                (_corners[i].North - _corners[j].North, _corners[i].East - _corners[j].East);
            (double fromNorth, double fromEast) = (north - _corners[j].North, east - _corners[j].East);
            double length2 = (alongNorth * alongNorth) + (alongEast * alongEast);
            double part = length2 > 0 ? ((fromNorth * alongNorth) + (fromEast * alongEast)) / length2 : 0;
            part = Math.Max(0, Math.Min(1, part));
            (fromNorth, fromEast) = (fromNorth - (part * alongNorth), fromEast - (part * alongEast));
            best = Math.Min(best, Math.Sqrt((fromNorth * fromNorth) + (fromEast * fromEast)));
        }

        return best;
    }

    private static bool IsFinite(double value) => !double.IsNaN(value) && !double.IsInfinity(value);
}
