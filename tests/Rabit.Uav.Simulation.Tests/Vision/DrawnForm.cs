using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation.Tests.Vision;

/// <summary>A panel that a test draws: what is within its outline.</summary>
/// <param name="Shape">Its outline; a square, and a triangle with equal sides.</param>
/// <param name="X">Column of its centre.</param>
/// <param name="Y">Row of its centre.</param>
/// <param name="Side">Side of a square of its area, pixels.</param>
/// <param name="Angle">How far it is turned, radians.</param>
/// <param name="Arm">Of a cross, the width of its arms by its span.</param>
internal sealed record DrawnForm(
    TargetShape Shape, double X, double Y, double Side, double Angle, double Arm = 0.33)
{
    // Asked for 36 places of each pixel.
    private readonly double _cos = Math.Cos(Angle);
    private readonly double _sin = Math.Sin(Angle);

    /// <summary>How far it reaches from its centre at most.</summary>
    public double Reach => Side + 2;

    public bool Contains(double x, double y)
    {
        (double dx, double dy) = (x - X, y - Y);
        double u = ((dx * _cos) + (dy * _sin)) / Side;
        double v = ((dy * _cos) - (dx * _sin)) / Side;
        return Shape switch
        {
            TargetShape.Circle => ((u * u) + (v * v)) * Math.PI <= 1,
            TargetShape.Cross => IsInCross(Math.Abs(u), Math.Abs(v)),
            TargetShape.Triangle => IsInTriangle(u, v),
            _ => Math.Max(Math.Abs(u), Math.Abs(v)) <= 0.5,
        };
    }

    public bool IsInLeftHalf(double x, double y) => ((x - X) * _cos) + ((y - Y) * _sin) < 0;

    private bool IsInCross(double u, double v)
    {
        double half = 0.5 / Math.Sqrt((2 * Arm) - (Arm * Arm));
        return Math.Max(u, v) <= half && Math.Min(u, v) <= Arm * half;
    }

    // Each of its sides is as far from the centre.
    private static bool IsInTriangle(double u, double v)
    {
        double side = 2 / Math.Sqrt(Math.Sqrt(3));
        double inner = side / (2 * Math.Sqrt(3));
        double root = Math.Sqrt(0.75);
        return -v <= inner && (0.5 * v) + (root * u) <= inner && (0.5 * v) - (root * u) <= inner;
    }
}
