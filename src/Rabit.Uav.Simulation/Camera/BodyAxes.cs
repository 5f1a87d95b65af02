using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The three axes of a rotated body, forward, right and down, each as a vector in the outer frame. On purpose without
/// rotation matrices or quaternions: an error of sign in the geometry of the aircraft must not be repeated here. A
/// plain value.
/// </summary>
internal readonly struct BodyAxes(Vector3 forward, Vector3 right, Vector3 down)
{
    public Vector3 Forward { get; } = forward;

    public Vector3 Right { get; } = right;

    public Vector3 Down { get; } = down;

    /// <summary>
    /// The axes of a body that is rotated by yaw (to the right), pitch (nose up) and roll (right side down), radians.
    /// Where the nose points follows from yaw and pitch alone; without roll the right side is level; roll then turns
    /// right towards down, and down towards left.
    /// </summary>
    public static BodyAxes FromEulerAngles(double yaw, double pitch, double roll)
    {
        (double sinYaw, double cosYaw) = (Trig.Sin(yaw), Trig.Cos(yaw));
        (double sinPitch, double cosPitch) = (Trig.Sin(pitch), Trig.Cos(pitch));
        (double sinRoll, double cosRoll) = (Trig.Sin(roll), Trig.Cos(roll));

        var forward = new Vector3(cosPitch * cosYaw, cosPitch * sinYaw, -sinPitch);
        var levelRight = new Vector3(-sinYaw, cosYaw, 0);
        var levelDown = new Vector3(sinPitch * cosYaw, sinPitch * sinYaw, cosPitch);   // forward x right
        return new BodyAxes(
            forward, Blend(levelRight, cosRoll, levelDown, sinRoll), Blend(levelDown, cosRoll, levelRight, -sinRoll));
    }

    /// <summary>These axes, which are given against others, in the frame of those others.</summary>
    public BodyAxes TransformedBy(in BodyAxes outer)
        => new(outer.Transform(Forward), outer.Transform(Right), outer.Transform(Down));

    /// <summary>A vector that is given along these axes, in the frame these axes are given in.</summary>
    public Vector3 Transform(Vector3 vector) => new(
        (vector.First * Forward.First) + (vector.Second * Right.First) + (vector.Third * Down.First),
        (vector.First * Forward.Second) + (vector.Second * Right.Second) + (vector.Third * Down.Second),
        (vector.First * Forward.Third) + (vector.Second * Right.Third) + (vector.Third * Down.Third));

    private static Vector3 Blend(Vector3 a, double partOfA, Vector3 b, double partOfB) => new(
        (a.First * partOfA) + (b.First * partOfB), (a.Second * partOfA) + (b.Second * partOfB),
        (a.Third * partOfA) + (b.Third * partOfB));
}
