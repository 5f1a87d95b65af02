namespace Rabit.Uav.Geometry;

/// <summary>A place on the WGS-84 ellipsoid with its altitude above mean sea level. A plain value.</summary>
/// <param name="latitudeRadians">-pi/2 to pi/2, north positive.</param>
/// <param name="longitudeRadians">-pi to pi, east positive.</param>
/// <param name="altitudeAmslMetres">Above mean sea level, up positive.</param>
public readonly struct GeodeticPosition(double latitudeRadians, double longitudeRadians, double altitudeAmslMetres)
{
    /// <summary>-pi/2 to pi/2, north positive.</summary>
    public double LatitudeRadians { get; } = latitudeRadians;

    /// <summary>-pi to pi, east positive.</summary>
    public double LongitudeRadians { get; } = longitudeRadians;

    /// <summary>Above mean sea level, up positive.</summary>
    public double AltitudeAmslMetres { get; } = altitudeAmslMetres;

    /// <summary>Without its altitude.</summary>
    public GeographicPoint Point => new(Angle.FromRadians(LatitudeRadians), Angle.FromRadians(LongitudeRadians));

    /// <summary>Its altitude, as a type that is not mixed up with other heights.</summary>
    public AmslAltitude Altitude => new(AltitudeAmslMetres);

    /// <summary>With its height above the ellipsoid.</summary>
    /// <param name="geoidUndulationMetres">How far the geoid is above the ellipsoid there, -107 to 86 m on earth.</param>
    public EllipsoidPosition ToEllipsoid(double geoidUndulationMetres) => new(Point, Altitude.ToEllipsoid(geoidUndulationMetres));
}
