using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>Sums of vectors, and what else the simulation counts with.</summary>
internal static class NedMath
{
    /// <summary>Standard gravity, m/s2.</summary>
    public const double Gravity = 9.806_65;

    public const double RadiansPerDegree = Math.PI / 180;

    public static NedVector Plus(this NedVector a, NedVector b)
        => new(a.North + b.North, a.East + b.East, a.Down + b.Down);

    public static NedVector Minus(this NedVector a, NedVector b)
        => new(a.North - b.North, a.East - b.East, a.Down - b.Down);

    public static NedVector Times(this NedVector a, double factor)
        => new(a.North * factor, a.East * factor, a.Down * factor);

    public static double HorizontalLength(this NedVector a) => Math.Sqrt((a.North * a.North) + (a.East * a.East));

    /// <summary>The vector with its horizontal part shortened to a length, if it is longer.</summary>
    public static NedVector LimitedHorizontally(this NedVector a, double length)
    {
        double own = a.HorizontalLength();
        return own <= length ? a : new NedVector(a.North * length / own, a.East * length / own, a.Down);
    }

    public static double Limited(double value, double low, double high)
        => value < low ? low : value > high ? high : value;

    /// <summary>An angle from -pi to pi.</summary>
    public static double Wrapped(double radians) => Math.IEEERemainder(radians, 2 * Math.PI);
}
