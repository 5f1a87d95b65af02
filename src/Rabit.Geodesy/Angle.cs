using System;
using System.Globalization;

namespace Rabit.Geodesy;

/// <summary>
/// An angle that knows its unit: made from degrees or from radians by name, never from a bare number. It keeps both, so
/// that degrees come back to the last digit. A plain value.
/// </summary>
/// <example>
/// <code>
/// Angle heading = Angle.FromDegrees(350) + Angle.FromDegrees(20);
/// Console.WriteLine(heading.Wrapped());            // 10°
/// Console.WriteLine(Math.Sin(heading.Radians));
/// </code>
/// </example>
public readonly struct Angle : IEquatable<Angle>, IComparable<Angle>
{
    /// <summary>Radians in a degree: the one place where it is defined.</summary>
    public const double RadiansPerDegree = Math.PI / 180;

    private Angle(double radians, double degrees) => (Radians, Degrees) = (radians, degrees);

    /// <summary>No angle.</summary>
    public static Angle Zero => default;

    /// <summary>Not a number: where an angle is not known or not wanted.</summary>
    public static Angle NaN => new(double.NaN, double.NaN);

    /// <summary>In radians.</summary>
    public double Radians { get; }

    /// <summary>In degrees; exactly those that it was made from.</summary>
    public double Degrees { get; }

    /// <summary>Whether it is a number, and not an infinite one.</summary>
    public bool IsFinite => !double.IsNaN(Radians) && !double.IsInfinity(Radians);

    /// <summary>Sum.</summary>
    public static Angle operator +(Angle a, Angle b) => new(a.Radians + b.Radians, a.Degrees + b.Degrees);

    /// <summary>Difference, not brought to any range.</summary>
    public static Angle operator -(Angle a, Angle b) => new(a.Radians - b.Radians, a.Degrees - b.Degrees);

    /// <summary>The opposite angle.</summary>
    public static Angle operator -(Angle a) => new(-a.Radians, -a.Degrees);

    /// <summary>A multiple.</summary>
    public static Angle operator *(double factor, Angle a) => new(factor * a.Radians, factor * a.Degrees);

    /// <summary>A multiple.</summary>
    public static Angle operator *(Angle a, double factor) => factor * a;

    /// <summary>A part.</summary>
    public static Angle operator /(Angle a, double divisor) => new(a.Radians / divisor, a.Degrees / divisor);

    /// <summary>How many times one angle is in another.</summary>
    public static double operator /(Angle a, Angle b) => a.Radians / b.Radians;

    /// <summary>Whether both are the same number of radians.</summary>
    public static bool operator ==(Angle a, Angle b) => a.Equals(b);

    /// <summary>Whether they are different.</summary>
    public static bool operator !=(Angle a, Angle b) => !a.Equals(b);

    /// <summary>Whether the first is smaller; false where one is not a number.</summary>
    public static bool operator <(Angle a, Angle b) => a.Radians < b.Radians;

    /// <summary>Whether the first is larger; false where one is not a number.</summary>
    public static bool operator >(Angle a, Angle b) => a.Radians > b.Radians;

    /// <summary>Whether the first is not larger; false where one is not a number.</summary>
    public static bool operator <=(Angle a, Angle b) => a.Radians <= b.Radians;

    /// <summary>Whether the first is not smaller; false where one is not a number.</summary>
    public static bool operator >=(Angle a, Angle b) => a.Radians >= b.Radians;

    /// <summary>From radians.</summary>
    /// <param name="radians">Any number.</param>
    public static Angle FromRadians(double radians) => new(radians, radians / RadiansPerDegree);

    /// <summary>From degrees.</summary>
    /// <param name="degrees">Any number.</param>
    public static Angle FromDegrees(double degrees) => new(degrees * RadiansPerDegree, degrees);

    /// <summary>The same direction from -pi to pi, -180 to 180 degrees.</summary>
    public Angle Wrapped()
    {
        double radians = Math.IEEERemainder(Radians, 2 * Math.PI);
        double degrees = Math.IEEERemainder(Degrees, 360);

        // Straight backwards, rounding may have sent the two to different ends of the range.
        return Math.Abs((radians / RadiansPerDegree) - degrees) < 180
            ? new Angle(radians, degrees)
            : FromRadians(radians);
    }

    /// <inheritdoc/>
    public int CompareTo(Angle other) => Radians.CompareTo(other.Radians);

    /// <inheritdoc/>
    public bool Equals(Angle other) => Radians.Equals(other.Radians);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is Angle other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => Radians.GetHashCode();

    /// <summary>In degrees with their sign, as 12.5°.</summary>
    public override string ToString() => Degrees.ToString("0.#########", CultureInfo.InvariantCulture) + "°";
}
