using System;

namespace Rabit.Geodesy;

/// <summary>
/// A displacement between two places in the earth-centred, earth-fixed frame of WGS-84, see <see cref="EcefPosition"/>;
/// in metres, unless the name of what holds it says another unit. A plain value.
/// </summary>
/// <param name="X">Towards latitude 0, longitude 0.</param>
/// <param name="Y">Towards latitude 0, longitude 90 degrees east.</param>
/// <param name="Z">Towards the north pole.</param>
public readonly record struct EcefVector(double X, double Y, double Z)
{
    /// <summary>No length.</summary>
    public static EcefVector Zero => default;

    /// <summary>Its length, in its unit.</summary>
    public double Length => Math.Sqrt((X * X) + (Y * Y) + (Z * Z));

    /// <summary>Its length squared.</summary>
    public double LengthSquared => (X * X) + (Y * Y) + (Z * Z);

    /// <summary>Whether all components are numbers, and not infinite ones.</summary>
    public bool IsFinite => FiniteNumbers.AreFinite(X, Y, Z);

    /// <summary>Sum.</summary>
    public static EcefVector operator +(EcefVector a, EcefVector b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    /// <summary>Difference.</summary>
    public static EcefVector operator -(EcefVector a, EcefVector b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    /// <summary>The opposite vector.</summary>
    public static EcefVector operator -(EcefVector a) => new(-a.X, -a.Y, -a.Z);

    /// <summary>A multiple.</summary>
    public static EcefVector operator *(double factor, EcefVector a) => new(factor * a.X, factor * a.Y, factor * a.Z);

    /// <summary>A multiple.</summary>
    public static EcefVector operator *(EcefVector a, double factor) => factor * a;

    /// <summary>A part.</summary>
    public static EcefVector operator /(EcefVector a, double divisor)
        => new(a.X / divisor, a.Y / divisor, a.Z / divisor);

    /// <summary>Dot product: the product of the lengths and the cosine of the angle between them.</summary>
    public static double Dot(EcefVector a, EcefVector b) => (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z);

    /// <summary>Cross product: at right angles to both, by the right-hand rule.</summary>
    public static EcefVector Cross(EcefVector a, EcefVector b) => new(
        (a.Y * b.Z) - (a.Z * b.Y),
        (a.Z * b.X) - (a.X * b.Z),
        (a.X * b.Y) - (a.Y * b.X));

    /// <summary>The vector of length 1 in its direction; not a number where it has no length.</summary>
    public EcefVector Normalized() => this / Length;

    /// <summary>Its components, three decimals.</summary>
    public override string ToString() => FormattableString.Invariant($"({X:0.###}, {Y:0.###}, {Z:0.###})");
}
