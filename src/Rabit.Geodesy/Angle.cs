using System;
using System.Globalization;

namespace Rabit.Geodesy;

/// <summary>An angle that knows its unit: made from degrees or from radians by name, never from a bare number. A plain value.</summary>
public readonly struct Angle : IEquatable<Angle>
{
    private const double RadiansPerDegree = Math.PI / 180;

    private Angle(double radians)
    {
        Radians = radians;
    }

    /// <summary>No angle.</summary>
    public static Angle Zero => default;

    /// <summary>In radians.</summary>
    public double Radians { get; }

    /// <summary>In degrees.</summary>
    public double Degrees => Radians / RadiansPerDegree;

    /// <summary>Whether it is a number, and not an endless one.</summary>
    public bool IsFinite => !double.IsNaN(Radians) && !double.IsInfinity(Radians);

    /// <summary>Sum.</summary>
    public static Angle operator +(Angle a, Angle b) => new(a.Radians + b.Radians);

    /// <summary>Difference, not brought to any range.</summary>
    public static Angle operator -(Angle a, Angle b) => new(a.Radians - b.Radians);

    /// <summary>The other way round.</summary>
    public static Angle operator -(Angle a) => new(-a.Radians);

    /// <summary>A multiple.</summary>
    public static Angle operator *(double factor, Angle a) => new(factor * a.Radians);

    /// <summary>Whether both are the same number of radians.</summary>
    public static bool operator ==(Angle a, Angle b) => a.Equals(b);

    /// <summary>Whether they are different.</summary>
    public static bool operator !=(Angle a, Angle b) => !a.Equals(b);

    /// <summary>From radians.</summary>
    /// <param name="radians">Any number.</param>
    public static Angle FromRadians(double radians) => new(radians);

    /// <summary>From degrees.</summary>
    /// <param name="degrees">Any number.</param>
    public static Angle FromDegrees(double degrees) => new(degrees * RadiansPerDegree);

    /// <summary>The same direction from -pi to pi.</summary>
    public Angle Wrapped() => new(Math.IEEERemainder(Radians, 2 * Math.PI));

    /// <inheritdoc/>
    public bool Equals(Angle other) => Radians.Equals(other.Radians);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is Angle other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => Radians.GetHashCode();

    /// <summary>In degrees with their sign, as 12.5°.</summary>
    public override string ToString() => Degrees.ToString("0.#########", CultureInfo.InvariantCulture) + "°";
}
