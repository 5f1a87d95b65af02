using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The three axes of something that is turned, forward, right and down, each as an arrow in the frame it is turned against. On purpose
/// without rotation matrices or quaternions: an error of sign in the geometry of the aircraft must not find its like here. A plain value.
/// </summary>
internal readonly struct BodyAxes(Arrow forward, Arrow right, Arrow down)
{
    public Arrow Forward { get; } = forward;

    public Arrow Right { get; } = right;

    public Arrow Down { get; } = down;

    /// <summary>
    /// What is turned by yaw (to the right), pitch (nose up) and roll (right side down), radians. Where the nose points follows from yaw and
    /// pitch alone; without roll the right side is level; roll then turns right towards down, and down towards left.
    /// </summary>
    public static BodyAxes Turned(double yaw, double pitch, double roll)
    {
        (double sinYaw, double cosYaw) = (Math.Sin(yaw), Math.Cos(yaw));
        (double sinPitch, double cosPitch) = (Math.Sin(pitch), Math.Cos(pitch));
        (double sinRoll, double cosRoll) = (Math.Sin(roll), Math.Cos(roll));

        var forward = new Arrow(cosPitch * cosYaw, cosPitch * sinYaw, -sinPitch);
        var levelRight = new Arrow(-sinYaw, cosYaw, 0);
        var levelDown = new Arrow(sinPitch * cosYaw, sinPitch * sinYaw, cosPitch);   // forward x right
        return new BodyAxes(forward, Blend(levelRight, cosRoll, levelDown, sinRoll), Blend(levelDown, cosRoll, levelRight, -sinRoll));
    }

    /// <summary>These axes, which are given against others, in the frame of those others.</summary>
    public BodyAxes Within(in BodyAxes outer) => new(outer.Carry(Forward), outer.Carry(Right), outer.Carry(Down));

    /// <summary>An arrow that is given along these axes, in the frame these axes are given in.</summary>
    public Arrow Carry(Arrow arrow) => new(
        (arrow.First * Forward.First) + (arrow.Second * Right.First) + (arrow.Third * Down.First),
        (arrow.First * Forward.Second) + (arrow.Second * Right.Second) + (arrow.Third * Down.Second),
        (arrow.First * Forward.Third) + (arrow.Second * Right.Third) + (arrow.Third * Down.Third));

    private static Arrow Blend(Arrow a, double partOfA, Arrow b, double partOfB) => new(
        (a.First * partOfA) + (b.First * partOfB), (a.Second * partOfA) + (b.Second * partOfB), (a.Third * partOfA) + (b.Third * partOfB));
}
