using System;

namespace Rabit.Geodesy;

/// <summary>
/// Height above the home position of the autopilot. It becomes another kind of height only by a method that is given
/// what lies between. A plain value.
/// </summary>
/// <param name="metres">Up positive.</param>
public readonly struct HeightAboveHome(double metres) : IEquatable<HeightAboveHome>
{
    /// <summary>Metres, up positive.</summary>
    public double Metres { get; } = metres;

    /// <summary>Whether both are the same number of metres.</summary>
    public static bool operator ==(HeightAboveHome a, HeightAboveHome b) => a.Equals(b);

    /// <summary>Whether they are different.</summary>
    public static bool operator !=(HeightAboveHome a, HeightAboveHome b) => !a.Equals(b);

    /// <summary>Above mean sea level.</summary>
    /// <param name="home">Where home is.</param>
    public AmslAltitude ToAmsl(AmslAltitude home) => new(Metres + home.Metres);

    /// <inheritdoc/>
    public bool Equals(HeightAboveHome other) => Metres.Equals(other.Metres);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is HeightAboveHome other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => Metres.GetHashCode();

    /// <summary>With its unit and what it is above.</summary>
    public override string ToString() => FormattableString.Invariant($"{Metres:0.###} m above home");
}
