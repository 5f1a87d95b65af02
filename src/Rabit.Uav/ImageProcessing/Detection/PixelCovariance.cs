using System;

namespace Rabit.Uav.ImageProcessing;

/// <summary>How uncertain a place in a picture is: a 2 x 2 covariance, square pixels. A plain value.</summary>
/// <param name="columnColumn">Variance of the column.</param>
/// <param name="columnRow">Covariance of column and row.</param>
/// <param name="rowRow">Variance of the row.</param>
public readonly struct PixelCovariance(double columnColumn, double columnRow, double rowRow)
    : IEquatable<PixelCovariance>
{
    /// <summary>Variance of the column, square pixels.</summary>
    public double ColumnColumn { get; } = columnColumn;

    /// <summary>Covariance of column and row, square pixels.</summary>
    public double ColumnRow { get; } = columnRow;

    /// <summary>Variance of the row, square pixels.</summary>
    public double RowRow { get; } = rowRow;

    /// <summary>Whether it is one: finite, and of a positive area.</summary>
    public bool IsPositiveDefinite
        => ColumnColumn is > 0 and < double.PositiveInfinity
            && RowRow is > 0 and < double.PositiveInfinity
            && (ColumnColumn * RowRow) - (ColumnRow * ColumnRow) > 0;

    /// <summary>Whether two are the same.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    public static bool operator ==(PixelCovariance left, PixelCovariance right) => left.Equals(right);

    /// <summary>Whether two differ.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    public static bool operator !=(PixelCovariance left, PixelCovariance right) => !left.Equals(right);

    /// <summary>The same standard deviation in every direction.</summary>
    /// <param name="pixels">One standard deviation per axis, pixels.</param>
    public static PixelCovariance FromSigma(double pixels) => new(pixels * pixels, 0, pixels * pixels);

    /// <inheritdoc/>
    public bool Equals(PixelCovariance other)
        => ColumnColumn.Equals(other.ColumnColumn) && ColumnRow.Equals(other.ColumnRow) && RowRow.Equals(other.RowRow);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is PixelCovariance other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode()
        => unchecked((((ColumnColumn.GetHashCode() * 397) ^ ColumnRow.GetHashCode()) * 397) ^ RowRow.GetHashCode());

    /// <summary>Its three numbers, square pixels.</summary>
    public override string ToString()
        => FormattableString.Invariant($"[{ColumnColumn}, {ColumnRow}; {ColumnRow}, {RowRow}] px2");
}
