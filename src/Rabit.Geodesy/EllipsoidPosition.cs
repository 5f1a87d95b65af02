using System;

namespace Rabit.Geodesy;

/// <summary>A place with its height above the WGS-84 ellipsoid. A plain value.</summary>
/// <param name="Point">Where it is on the ellipsoid.</param>
/// <param name="Height">How far above.</param>
public readonly record struct EllipsoidPosition(GeographicPoint Point, EllipsoidHeight Height)
{
    /// <summary>
    /// From an earth-centred position; at the poles the longitude is 0 or 180 degrees. At the centre of the earth it is
    /// not a place.
    /// </summary>
    /// <param name="position">Not nearer than 50 km to the centre of the earth.</param>
    public static EllipsoidPosition FromEcef(EcefPosition position)
    {
        (double latitude, double longitude, double height) = Wgs84.FromEarthCentred(
            position.XMetres, position.YMetres, position.ZMetres);
        return new EllipsoidPosition(
            new GeographicPoint(Angle.FromRadians(latitude), Angle.FromRadians(longitude)),
            new EllipsoidHeight(height));
    }

    /// <summary>Earth-centred.</summary>
    public EcefPosition ToEcef()
    {
        (double x, double y, double z) = Wgs84.ToEarthCentred(
            Point.Latitude.Radians, Point.Longitude.Radians, Height.Metres);
        return new EcefPosition(x, y, z);
    }

    /// <summary>With its altitude above mean sea level, as autopilots report it.</summary>
    /// <param name="geoidUndulationMetres">How far the geoid is above the ellipsoid there.</param>
    public GeodeticPosition ToAmsl(double geoidUndulationMetres)
        => new(Point, Height.ToAmsl(geoidUndulationMetres));

    /// <summary>With its altitude above mean sea level.</summary>
    /// <param name="geoid">How far the geoid is above the ellipsoid.</param>
    public GeodeticPosition ToAmsl(GeoidGrid geoid)
        => ToAmsl((geoid ?? throw new ArgumentNullException(nameof(geoid))).UndulationMetres(Point));

    /// <summary>In decimal degrees and metres.</summary>
    public override string ToString() => $"{Point}, {Height}";
}
