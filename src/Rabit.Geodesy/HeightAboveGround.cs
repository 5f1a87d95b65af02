using System;

namespace Rabit.Geodesy;

/// <summary>
/// Height above the ground straight below. It becomes another kind of height only by a method that is given what lies
/// between. A plain value.
/// </summary>
/// <param name="metres">Up positive.</param>
public readonly struct HeightAboveGround(double metres) : IEquatable<HeightAboveGround>
{
    /// <summary>Metres, up positive.</summary>
    public double Metres { get; } = metres;

    /// <summary>Whether both are the same number of metres.</summary>
    public static bool operator ==(HeightAboveGround a, HeightAboveGround b) => a.Equals(b);

    /// <summary>Whether they are different.</summary>
    public static bool operator !=(HeightAboveGround a, HeightAboveGround b) => !a.Equals(b);

    /// <summary>Above mean sea level.</summary>
    /// <param name="ground">Where the ground is, at the same place.</param>
    public AmslAltitude ToAmsl(AmslAltitude ground) => new(Metres + ground.Metres);

    /// <inheritdoc/>
    public bool Equals(HeightAboveGround other) => Metres.Equals(other.Metres);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is HeightAboveGround other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => Metres.GetHashCode();

    /// <summary>With its unit and what it is above.</summary>
    public override string ToString() => FormattableString.Invariant($"{Metres:0.###} m above the ground");
}
