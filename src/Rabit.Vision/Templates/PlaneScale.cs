using System;

namespace Rabit.Vision;

/// <summary>
/// How far one pixel reaches on a plane, as the ground, at a place of the picture: metres for a pixel, along two axes
/// of the plane. With x to the north and y to the east, angles are headings, clockwise from north. A plain value.
/// </summary>
/// <param name="xByColumn">Metres along x per column to the right.</param>
/// <param name="xByRow">Metres along x per row down.</param>
/// <param name="yByColumn">Metres along y per column to the right.</param>
/// <param name="yByRow">Metres along y per row down.</param>
public readonly struct PlaneScale(double xByColumn, double xByRow, double yByColumn, double yByRow)
    : IEquatable<PlaneScale>
{
    /// <summary>Metres along x per column to the right.</summary>
    public double XByColumn { get; } = xByColumn;

    /// <summary>Metres along x per row down.</summary>
    public double XByRow { get; } = xByRow;

    /// <summary>Metres along y per column to the right.</summary>
    public double YByColumn { get; } = yByColumn;

    /// <summary>Metres along y per row down.</summary>
    public double YByRow { get; } = yByRow;

    /// <summary>Square metres that a pixel covers.</summary>
    public double PixelArea => Math.Abs(Determinant);

    internal double Determinant => (XByColumn * YByRow) - (XByRow * YByColumn);

    /// <summary>Whether two are the same.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    public static bool operator ==(PlaneScale left, PlaneScale right) => left.Equals(right);

    /// <summary>Whether two differ.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    public static bool operator !=(PlaneScale left, PlaneScale right) => !left.Equals(right);

    /// <summary>From straight above, top of the picture along x.</summary>
    /// <param name="metresPerPixel">Side of a pixel.</param>
    public static PlaneScale Uniform(double metresPerPixel) => new(0, -metresPerPixel, metresPerPixel, 0);

    /// <inheritdoc/>
    public bool Equals(PlaneScale other)
        => XByColumn.Equals(other.XByColumn) && XByRow.Equals(other.XByRow)
            && YByColumn.Equals(other.YByColumn) && YByRow.Equals(other.YByRow);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is PlaneScale other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => unchecked((XByColumn.GetHashCode() * 397) ^ YByRow.GetHashCode());

    internal PlaneScale Times(double factor)
        => new(XByColumn * factor, XByRow * factor, YByColumn * factor, YByRow * factor);

    /// <summary>Metres on the plane of a way in the picture.</summary>
    internal (double X, double Y) ToPlane(double columns, double rows)
        => ((XByColumn * columns) + (XByRow * rows), (YByColumn * columns) + (YByRow * rows));

    /// <summary>Pixels of a way on the plane.</summary>
    internal (double Columns, double Rows) ToPicture(double x, double y)
        => (((YByRow * x) - (XByRow * y)) / Determinant, ((XByColumn * y) - (YByColumn * x)) / Determinant);
}
