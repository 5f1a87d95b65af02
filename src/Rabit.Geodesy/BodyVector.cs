using System;

namespace Rabit.Geodesy;

/// <summary>
/// A vector in the body frame, forward-right-down: a lever arm, a velocity, a direction. The name of what holds it says
/// its unit. It becomes a <see cref="NedVector"/> by the attitude, <see cref="Rotation.ToNed"/>. A plain value.
/// </summary>
/// <param name="Forward">Along the nose.</param>
/// <param name="Right">Along the right wing.</param>
/// <param name="Down">Through the floor.</param>
public readonly record struct BodyVector(double Forward, double Right, double Down)
{
    /// <summary>No length.</summary>
    public static BodyVector Zero => default;

    /// <summary>Its length, in its unit.</summary>
    public double Length => Math.Sqrt((Forward * Forward) + (Right * Right) + (Down * Down));

    /// <summary>Its length squared.</summary>
    public double LengthSquared => (Forward * Forward) + (Right * Right) + (Down * Down);

    /// <summary>Whether all components are numbers, and not infinite ones.</summary>
    public bool IsFinite => FiniteNumbers.AreFinite(Forward, Right, Down);

    /// <summary>Sum.</summary>
    public static BodyVector operator +(BodyVector a, BodyVector b)
        => new(a.Forward + b.Forward, a.Right + b.Right, a.Down + b.Down);

    /// <summary>Difference.</summary>
    public static BodyVector operator -(BodyVector a, BodyVector b)
        => new(a.Forward - b.Forward, a.Right - b.Right, a.Down - b.Down);

    /// <summary>The opposite vector.</summary>
    public static BodyVector operator -(BodyVector a) => new(-a.Forward, -a.Right, -a.Down);

    /// <summary>A multiple.</summary>
    public static BodyVector operator *(double factor, BodyVector a)
        => new(factor * a.Forward, factor * a.Right, factor * a.Down);

    /// <summary>A multiple.</summary>
    public static BodyVector operator *(BodyVector a, double factor) => factor * a;

    /// <summary>A part.</summary>
    public static BodyVector operator /(BodyVector a, double divisor)
        => new(a.Forward / divisor, a.Right / divisor, a.Down / divisor);

    /// <summary>Dot product: the product of the lengths and the cosine of the angle between them.</summary>
    public static double Dot(BodyVector a, BodyVector b)
        => (a.Forward * b.Forward) + (a.Right * b.Right) + (a.Down * b.Down);

    /// <summary>Cross product: at right angles to both, by the right-hand rule.</summary>
    public static BodyVector Cross(BodyVector a, BodyVector b) => new(
        (a.Right * b.Down) - (a.Down * b.Right),
        (a.Down * b.Forward) - (a.Forward * b.Down),
        (a.Forward * b.Right) - (a.Right * b.Forward));

    /// <summary>The vector of length 1 in its direction; not a number where it has no length.</summary>
    public BodyVector Normalized() => this / Length;

    /// <summary>Its components, three decimals.</summary>
    public override string ToString() => FormattableString.Invariant($"({Forward:0.###}, {Right:0.###}, {Down:0.###})");
}
