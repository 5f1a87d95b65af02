using System;

namespace Rabit.Vision;

/// <summary>
/// The outer corners of a marker's black square, in the order of the upright marker as it is printed: top left, top
/// right, bottom right, bottom left. A plain value.
/// </summary>
/// <param name="topLeft">Top left, in the picture.</param>
/// <param name="topRight">Top right, in the picture.</param>
/// <param name="bottomRight">Bottom right, in the picture.</param>
/// <param name="bottomLeft">Bottom left, in the picture.</param>
public readonly struct MarkerCorners(
    PicturePoint topLeft, PicturePoint topRight, PicturePoint bottomRight, PicturePoint bottomLeft)
    : IEquatable<MarkerCorners>
{
    /// <summary>Top left of the upright marker.</summary>
    public PicturePoint TopLeft { get; } = topLeft;

    /// <summary>Top right of the upright marker.</summary>
    public PicturePoint TopRight { get; } = topRight;

    /// <summary>Bottom right of the upright marker.</summary>
    public PicturePoint BottomRight { get; } = bottomRight;

    /// <summary>Bottom left of the upright marker.</summary>
    public PicturePoint BottomLeft { get; } = bottomLeft;

    /// <summary>One of the four: 0 for top left, and on clockwise.</summary>
    /// <param name="index">0 to 3.</param>
    public PicturePoint this[int index] => index switch
    {
        0 => TopLeft,
        1 => TopRight,
        2 => BottomRight,
        3 => BottomLeft,
        _ => throw new ArgumentOutOfRangeException(nameof(index), index, "A marker has the corners 0 to 3."),
    };

    /// <summary>Where the middle of the marker is: its diagonals meet there.</summary>
    public PicturePoint Centre => PlaneMap.ToQuad(this).Map(0.5, 0.5);

    /// <summary>Whether two are the same.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    public static bool operator ==(MarkerCorners left, MarkerCorners right) => left.Equals(right);

    /// <summary>Whether two differ.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    public static bool operator !=(MarkerCorners left, MarkerCorners right) => !left.Equals(right);

    /// <inheritdoc/>
    public bool Equals(MarkerCorners other)
        => TopLeft == other.TopLeft && TopRight == other.TopRight && BottomRight == other.BottomRight
            && BottomLeft == other.BottomLeft;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is MarkerCorners other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => unchecked((TopLeft.GetHashCode() * 397) ^ BottomRight.GetHashCode());

    /// <summary>The four, with two decimals.</summary>
    public override string ToString() => $"{TopLeft} {TopRight} {BottomRight} {BottomLeft}";

    // Which corner comes first; clockwise stays clockwise.
    internal MarkerCorners From(int first) => new(
        this[first % 4], this[(first + 1) % 4], this[(first + 2) % 4], this[(first + 3) % 4]);

    internal double MinSide => Math.Min(
        Math.Min(TopLeft.DistanceTo(TopRight), TopRight.DistanceTo(BottomRight)),
        Math.Min(BottomRight.DistanceTo(BottomLeft), BottomLeft.DistanceTo(TopLeft)));
}
