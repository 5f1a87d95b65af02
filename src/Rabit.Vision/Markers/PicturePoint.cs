using System;

namespace Rabit.Vision;

/// <summary>A place in a picture. A plain value.</summary>
/// <param name="x">Column, pixels; the centre of the top left pixel is 0.</param>
/// <param name="y">Row, pixels; the centre of the top left pixel is 0.</param>
public readonly struct PicturePoint(double x, double y) : IEquatable<PicturePoint>
{
    /// <summary>Column, pixels; the centre of the top left pixel is 0.</summary>
    public double X { get; } = x;

    /// <summary>Row, pixels; the centre of the top left pixel is 0.</summary>
    public double Y { get; } = y;

    /// <summary>Whether two are the same.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    public static bool operator ==(PicturePoint left, PicturePoint right) => left.Equals(right);

    /// <summary>Whether two differ.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    public static bool operator !=(PicturePoint left, PicturePoint right) => !left.Equals(right);

    /// <inheritdoc/>
    public bool Equals(PicturePoint other) => X.Equals(other.X) && Y.Equals(other.Y);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is PicturePoint other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => unchecked((X.GetHashCode() * 397) ^ Y.GetHashCode());

    /// <summary>Column and row, with two decimals.</summary>
    public override string ToString() => FormattableString.Invariant($"({X:0.00}, {Y:0.00})");

    internal double DistanceTo(PicturePoint other)
        => Math.Sqrt(((X - other.X) * (X - other.X)) + ((Y - other.Y) * (Y - other.Y)));
}
