using System;

namespace Rabit.Geodesy;

/// <summary>
/// The shortest line between two places on the ellipsoid, see <see cref="Geodesic.Inverse"/>. A plain value.
/// </summary>
/// <param name="DistanceMetres">How long it is.</param>
/// <param name="StartAzimuth">Its direction at the first place, clockwise from north, -180 to 180 degrees.</param>
/// <param name="EndAzimuth">Its direction at the second place, going on, -180 to 180 degrees.</param>
public readonly record struct GeodesicLine(double DistanceMetres, Angle StartAzimuth, Angle EndAzimuth)
{
    /// <summary>As 1234.567 m at 45.5°.</summary>
    public override string ToString() => FormattableString.Invariant($"{DistanceMetres:0.000} m at {StartAzimuth}");
}
