using System;

namespace Rabit.Geodesy;

/// <summary>A position in the earth-centred, earth-fixed frame of WGS-84. A plain value.</summary>
/// <param name="XMetres">Towards latitude 0, longitude 0.</param>
/// <param name="YMetres">Towards latitude 0, longitude 90 degrees east.</param>
/// <param name="ZMetres">Towards the north pole.</param>
public readonly record struct EcefPosition(double XMetres, double YMetres, double ZMetres)
{
    /// <summary>From one place to another, in a straight line.</summary>
    public static EcefVector operator -(EcefPosition to, EcefPosition from)
        => new(to.XMetres - from.XMetres, to.YMetres - from.YMetres, to.ZMetres - from.ZMetres);

    /// <summary>A place some metres away.</summary>
    public static EcefPosition operator +(EcefPosition from, EcefVector metres)
        => new(from.XMetres + metres.X, from.YMetres + metres.Y, from.ZMetres + metres.Z);

    /// <summary>A place some metres away, the other way.</summary>
    public static EcefPosition operator -(EcefPosition from, EcefVector metres) => from + -metres;

    /// <summary>Metres to another place, in a straight line through the earth.</summary>
    /// <param name="other">The other place.</param>
    public double DistanceTo(EcefPosition other) => (other - this).Length;

    /// <summary>Its coordinates to a millimetre.</summary>
    public override string ToString()
        => FormattableString.Invariant($"({XMetres:0.000}, {YMetres:0.000}, {ZMetres:0.000}) m");
}
