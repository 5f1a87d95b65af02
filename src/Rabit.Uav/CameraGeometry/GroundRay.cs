using System;
using Rabit.Geodesy;

namespace Rabit.Uav.CameraGeometry;

/// <summary>A line of sight in a local north-east-down frame. A plain value.</summary>
/// <param name="fromMetres">Where it begins.</param>
/// <param name="direction">Where it goes, of any length but 0.</param>
public readonly struct GroundRay(NedVector fromMetres, NedVector direction)
{
    /// <summary>Where it begins, metres.</summary>
    public NedVector FromMetres { get; } = fromMetres;

    /// <summary>Where it goes, of any length but 0.</summary>
    public NedVector Direction { get; } = direction;

    /// <summary>How far below the horizon it points, radians.</summary>
    public double DepressionRadians => Math.Atan2(
        Direction.Down, Math.Sqrt((Direction.North * Direction.North) + (Direction.East * Direction.East)));

    /// <summary>Where it meets a level plane below; false where it begins below that plane, or points too near to the horizon or above it.</summary>
    /// <param name="downMetres">Where the plane is, down positive.</param>
    /// <param name="minimumDepressionRadians">It must point further below the horizon than that: near the horizon every error grows without limit.</param>
    /// <param name="point">Where they meet, metres; nothing if the answer is false.</param>
    public bool TryIntersectLevel(double downMetres, double minimumDepressionRadians, out NedVector point)
    {
        double height = downMetres - FromMetres.Down;
        if (!(height > 0 && Direction.Down > 0 && DepressionRadians > minimumDepressionRadians))
        {
            point = default;
            return false;
        }

        double scale = height / Direction.Down;
        point = new NedVector(FromMetres.North + (scale * Direction.North), FromMetres.East + (scale * Direction.East), downMetres);
        return true;
    }

    /// <summary>Where it meets a plane that may slope; false where it goes away from it or along it.</summary>
    internal bool TryIntersectPlane(NedVector on, double downByNorth, double downByEast, out NedVector point)
    {
        double height = on.Down + (downByNorth * (FromMetres.North - on.North)) + (downByEast * (FromMetres.East - on.East)) - FromMetres.Down;
        double scale = height / (Direction.Down - (downByNorth * Direction.North) - (downByEast * Direction.East));
        point = new NedVector(
            FromMetres.North + (scale * Direction.North), FromMetres.East + (scale * Direction.East), FromMetres.Down + (scale * Direction.Down));
        return scale > 0 && !double.IsInfinity(scale);
    }
}
