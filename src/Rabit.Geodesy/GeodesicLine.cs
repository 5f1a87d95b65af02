namespace Rabit.Geodesy;

/// <summary>The shortest way between two places on the ellipsoid. A plain value.</summary>
/// <param name="distanceMetres">How long it is.</param>
/// <param name="startAzimuth">Its direction at the first place, clockwise from north.</param>
/// <param name="endAzimuth">Its direction at the second place, going on.</param>
public readonly struct GeodesicLine(double distanceMetres, Angle startAzimuth, Angle endAzimuth)
{
    /// <summary>How long it is, metres.</summary>
    public double DistanceMetres { get; } = distanceMetres;

    /// <summary>Its direction at the first place, clockwise from north, -180 to 180 degrees.</summary>
    public Angle StartAzimuth { get; } = startAzimuth;

    /// <summary>Its direction at the second place, going on, -180 to 180 degrees.</summary>
    public Angle EndAzimuth { get; } = endAzimuth;
}
