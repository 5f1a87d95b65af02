using System;

namespace Rabit.Geodesy;

/// <summary>
/// A displacement, velocity or direction in a local north-east-down frame; the name of what holds it says its unit. A
/// place in such a frame is a <see cref="NedPosition"/>. A plain value.
/// </summary>
/// <param name="North">To true north.</param>
/// <param name="East">To the east.</param>
/// <param name="Down">Towards the ground.</param>
/// <example>
/// <code>
/// var velocity = new NedVector(3, 4, 0);                    // metres per second
/// NedPosition after10Seconds = NedPosition.Origin + (10 * velocity);
/// Console.WriteLine(velocity.Length);                       // 5
/// </code>
/// </example>
public readonly record struct NedVector(double North, double East, double Down)
{
    /// <summary>No length.</summary>
    public static NedVector Zero => default;

    /// <summary>Its length, in its unit.</summary>
    public double Length => Math.Sqrt((North * North) + (East * East) + (Down * Down));

    /// <summary>Its length squared.</summary>
    public double LengthSquared => (North * North) + (East * East) + (Down * Down);

    /// <summary>The length of its horizontal part.</summary>
    public double HorizontalLength => Math.Sqrt((North * North) + (East * East));

    /// <summary>
    /// Where its horizontal part points, clockwise from north, -180 to 180 degrees; 0 where it has none.
    /// </summary>
    public Angle Azimuth => Angle.FromRadians(Math.Atan2(East, North));

    /// <summary>Whether all components are numbers, and not infinite ones.</summary>
    public bool IsFinite => FiniteNumbers.AreFinite(North, East, Down);

    /// <summary>Sum.</summary>
    public static NedVector operator +(NedVector a, NedVector b)
        => new(a.North + b.North, a.East + b.East, a.Down + b.Down);

    /// <summary>Difference.</summary>
    public static NedVector operator -(NedVector a, NedVector b)
        => new(a.North - b.North, a.East - b.East, a.Down - b.Down);

    /// <summary>The opposite vector.</summary>
    public static NedVector operator -(NedVector a) => new(-a.North, -a.East, -a.Down);

    /// <summary>A multiple.</summary>
    public static NedVector operator *(double factor, NedVector a)
        => new(factor * a.North, factor * a.East, factor * a.Down);

    /// <summary>A multiple.</summary>
    public static NedVector operator *(NedVector a, double factor) => factor * a;

    /// <summary>A part.</summary>
    public static NedVector operator /(NedVector a, double divisor)
        => new(a.North / divisor, a.East / divisor, a.Down / divisor);

    /// <summary>Dot product: the product of the lengths and the cosine of the angle between them.</summary>
    public static double Dot(NedVector a, NedVector b) => (a.North * b.North) + (a.East * b.East) + (a.Down * b.Down);

    /// <summary>Cross product: at right angles to both, by the right-hand rule.</summary>
    public static NedVector Cross(NedVector a, NedVector b) => new(
        (a.East * b.Down) - (a.Down * b.East),
        (a.Down * b.North) - (a.North * b.Down),
        (a.North * b.East) - (a.East * b.North));

    /// <summary>The vector of length 1 in its direction; not a number where it has no length.</summary>
    public NedVector Normalized() => this / Length;

    /// <summary>Its components, three decimals.</summary>
    public override string ToString() => FormattableString.Invariant($"({North:0.###}, {East:0.###}, {Down:0.###})");
}
