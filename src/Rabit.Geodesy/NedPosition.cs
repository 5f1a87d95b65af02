using System;

namespace Rabit.Geodesy;

/// <summary>
/// A place in a <see cref="LocalNedFrame"/>, metres from its origin. Between two places lies a <see cref="NedVector"/>;
/// places are not added. A plain value.
/// </summary>
/// <param name="North">Metres to true north of the origin.</param>
/// <param name="East">Metres east of it.</param>
/// <param name="Down">Metres below it.</param>
public readonly record struct NedPosition(double North, double East, double Down)
{
    /// <summary>The origin of the frame.</summary>
    public static NedPosition Origin => default;

    /// <summary>Whether all coordinates are numbers, and not infinite ones.</summary>
    public bool IsFinite => FiniteNumbers.AreFinite(North, East, Down);

    /// <summary>From one place to another, metres.</summary>
    public static NedVector operator -(NedPosition to, NedPosition from)
        => new(to.North - from.North, to.East - from.East, to.Down - from.Down);

    /// <summary>A place some metres away.</summary>
    public static NedPosition operator +(NedPosition from, NedVector metres)
        => new(from.North + metres.North, from.East + metres.East, from.Down + metres.Down);

    /// <summary>A place some metres away, the other way.</summary>
    public static NedPosition operator -(NedPosition from, NedVector metres)
        => new(from.North - metres.North, from.East - metres.East, from.Down - metres.Down);

    /// <summary>Metres to another place of the same frame.</summary>
    /// <param name="other">The other place.</param>
    public double DistanceTo(NedPosition other) => (other - this).Length;

    /// <summary>Metres to another place of the same frame, seen from above.</summary>
    /// <param name="other">The other place.</param>
    public double HorizontalDistanceTo(NedPosition other) => (other - this).HorizontalLength;

    /// <summary>Its coordinates to a millimetre.</summary>
    public override string ToString() => FormattableString.Invariant($"({North:0.###}, {East:0.###}, {Down:0.###}) m");
}
