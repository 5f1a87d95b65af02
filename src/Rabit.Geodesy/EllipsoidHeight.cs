using System;

namespace Rabit.Geodesy;

/// <summary>
/// Height above the WGS-84 ellipsoid, as satellite navigation measures it. It becomes another kind of height only by a
/// method that is given what lies between. A plain value.
/// </summary>
/// <param name="metres">Up positive.</param>
public readonly struct EllipsoidHeight(double metres) : IEquatable<EllipsoidHeight>
{
    /// <summary>Metres, up positive.</summary>
    public double Metres { get; } = metres;

    /// <summary>Whether both are the same number of metres.</summary>
    public static bool operator ==(EllipsoidHeight a, EllipsoidHeight b) => a.Equals(b);

    /// <summary>Whether they are different.</summary>
    public static bool operator !=(EllipsoidHeight a, EllipsoidHeight b) => !a.Equals(b);

    /// <summary>Above mean sea level.</summary>
    /// <param name="geoidUndulationMetres">
    /// How far the geoid is above the ellipsoid there, -107 to 86 m on earth; see <see cref="GeoidGrid"/>; it must be
    /// looked up, it cannot be computed.
    /// </param>
    public AmslAltitude ToAmsl(double geoidUndulationMetres) => new(Metres - geoidUndulationMetres);

    /// <inheritdoc/>
    public bool Equals(EllipsoidHeight other) => Metres.Equals(other.Metres);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is EllipsoidHeight other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => Metres.GetHashCode();

    /// <summary>With its unit and what it is above.</summary>
    public override string ToString() => FormattableString.Invariant($"{Metres:0.###} m above the ellipsoid");
}
