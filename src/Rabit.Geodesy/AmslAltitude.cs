using System;

namespace Rabit.Geodesy;

/// <summary>
/// Altitude above mean sea level, as autopilots and maps give it. It becomes another kind of height only by a method
/// that is given what lies between. A plain value.
/// </summary>
/// <param name="metres">Up positive.</param>
public readonly struct AmslAltitude(double metres) : IEquatable<AmslAltitude>
{
    /// <summary>Metres, up positive.</summary>
    public double Metres { get; } = metres;

    /// <summary>Whether both are the same number of metres.</summary>
    public static bool operator ==(AmslAltitude a, AmslAltitude b) => a.Equals(b);

    /// <summary>Whether they are different.</summary>
    public static bool operator !=(AmslAltitude a, AmslAltitude b) => !a.Equals(b);

    /// <summary>Above the ellipsoid.</summary>
    /// <param name="geoidUndulationMetres">
    /// How far the geoid is above the ellipsoid there, -107 to 86 m on earth; see <see cref="GeoidGrid"/>; it must be
    /// looked up, it cannot be computed.
    /// </param>
    public EllipsoidHeight ToEllipsoid(double geoidUndulationMetres) => new(Metres + geoidUndulationMetres);

    /// <summary>Above the ground.</summary>
    /// <param name="ground">Where the ground is, at the same place.</param>
    public HeightAboveGround Above(AmslAltitude ground) => new(Metres - ground.Metres);

    /// <summary>Above the home position.</summary>
    /// <param name="home">Where home is.</param>
    public HeightAboveHome AboveHome(AmslAltitude home) => new(Metres - home.Metres);

    /// <inheritdoc/>
    public bool Equals(AmslAltitude other) => Metres.Equals(other.Metres);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is AmslAltitude other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => Metres.GetHashCode();

    /// <summary>With its unit and what it is above.</summary>
    public override string ToString() => FormattableString.Invariant($"{Metres:0.###} m above mean sea level");
}
