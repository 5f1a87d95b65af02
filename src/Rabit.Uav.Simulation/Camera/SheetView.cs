using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// A flat rectangle on the ground seen from one pose of the camera: says of any ray whether it intersects the
/// rectangle. Along and across the rectangle, and downwards, a ray's way is linear in the ray; a ray's place on the
/// ground is one divided by the other, and comparing needs no division. A plain value.
/// </summary>
internal readonly struct SheetView
{
    private readonly Vector3 _along;    // what x, y and 1 of a ray each add
    private readonly Vector3 _across;
    private readonly Vector3 _down;
    private readonly double _halfSide;
    private readonly double _halfWidth;

    public SheetView(SimulatedTarget sheet, in CameraPose pose)
    {
        (double sin, double cos) = (Trig.Sin(sheet.Heading.Radians), Trig.Cos(sheet.Heading.Radians));
        NedPosition centre = sheet.PositionAt(pose.Time);
        (double north, double east) = (pose.North - centre.North, pose.East - centre.East);
        _along = Terms(pose, cos, sin, (north * cos) + (east * sin));
        _across = Terms(pose, -sin, cos, (east * cos) - (north * sin));
        _down = new Vector3(pose.Axes.Right.Third, pose.Axes.Down.Third, pose.Axes.Forward.Third);
        _halfSide = sheet.SideMetres / 2;
        _halfWidth = sheet.WidthMetres / 2;
    }

    /// <summary>Whether a ray meets the rectangle.</summary>
    public bool Contains(double x, double y) => SidesMissed(x, y) == 0;

    /// <summary>
    /// Beyond which sides of the rectangle a ray meets the ground, one bit each; all bits for a ray that does not
    /// meet it.
    /// </summary>
    public int SidesMissed(double x, double y)
    {
        double down = Value(_down, x, y);
        if (down <= 0)
            return 31;
        double along = Value(_along, x, y);
        double across = Value(_across, x, y);
        double side = _halfSide * down;
        double width = _halfWidth * down;
        return (along > side ? 1 : 0) | (along < -side ? 2 : 0) | (across > width ? 4 : 0) | (across < -width ? 8 : 0);
    }

    /// <summary>
    /// Where in the rectangle a ray meets it, from its forward left corner, in parts of its sides; false beside it.
    /// </summary>
    public bool TryLocate(double x, double y, out double back, out double right)
    {
        (back, right) = (0, 0);
        double down = Value(_down, x, y);
        if (down <= 0)
            return false;
        back = 0.5 - (Value(_along, x, y) / (2 * _halfSide * down));
        right = 0.5 + (Value(_across, x, y) / (2 * _halfWidth * down));
        return back is >= 0 and < 1 && right is >= 0 and < 1;
    }

    // Where a ray meets the ground: camera + height x (its level part) / (its part downwards); here times that part.
    private static Vector3 Terms(in CameraPose pose, double towardsNorth, double towardsEast, double camera) => new(
        Term(pose.Axes.Right, pose.Height, towardsNorth, towardsEast, camera),
        Term(pose.Axes.Down, pose.Height, towardsNorth, towardsEast, camera),
        Term(pose.Axes.Forward, pose.Height, towardsNorth, towardsEast, camera));

    private static double Term(Vector3 axis, double height, double towardsNorth, double towardsEast, double camera)
        => (height * ((axis.First * towardsNorth) + (axis.Second * towardsEast))) + (camera * axis.Third);

    private static double Value(Vector3 terms, double x, double y)
        => (terms.First * x) + (terms.Second * y) + terms.Third;
}
