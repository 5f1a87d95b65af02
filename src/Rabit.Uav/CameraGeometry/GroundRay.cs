using Rabit.Geodesy;

namespace Rabit.Uav.CameraGeometry;

/// <summary>A line of sight: a ray in a local north-east-down frame. A plain value.</summary>
/// <param name="Origin">Where it begins.</param>
/// <param name="Direction">Where it goes, of any length but 0.</param>
public readonly record struct GroundRay(NedPosition Origin, NedVector Direction)
{
    /// <summary>How far below the horizon it points.</summary>
    public Angle Depression => Angle.FromRadians(System.Math.Atan2(Direction.Down, Direction.HorizontalLength));

    /// <summary>
    /// Where it intersects a level plane below; false where it begins below that plane, or points too near to the
    /// horizon or above it.
    /// </summary>
    /// <param name="downMetres">Where the plane is, down positive.</param>
    /// <param name="minDepression">
    /// It must point further below the horizon than that: near the horizon every error grows without limit.
    /// </param>
    /// <param name="point">The intersection; nothing if the answer is false.</param>
    public bool TryIntersectLevel(double downMetres, Angle minDepression, out NedPosition point)
    {
        double height = downMetres - Origin.Down;
        if (!(height > 0 && Direction.Down > 0 && Depression > minDepression))
        {
            point = default;
            return false;
        }

        point = (Origin + (height / Direction.Down * Direction)) with { Down = downMetres };
        return true;
    }

    /// <summary>Its origin and direction.</summary>
    public override string ToString() => $"from {Origin} towards {Direction}";

    /// <summary>Where it intersects a plane that may slope; false where it goes away from it or along it.</summary>
    internal bool TryIntersectPlane(NedPosition on, double downByNorth, double downByEast, out NedPosition point)
    {
        double height = on.Down + (downByNorth * (Origin.North - on.North)) + (downByEast * (Origin.East - on.East))
            - Origin.Down;
        double scale = height / (Direction.Down - (downByNorth * Direction.North) - (downByEast * Direction.East));
        point = Origin + (scale * Direction);
        return scale > 0 && !double.IsInfinity(scale);
    }
}
