namespace Rabit.Geodesy;

/// <summary>A place on the WGS-84 ellipsoid with its altitude above mean sea level. A plain value.</summary>
/// <remarks>Made from things that know their unit and their datum, or from numbers by a method that names the unit; never from bare numbers.</remarks>
public readonly struct GeodeticPosition
{
    /// <summary>Makes it.</summary>
    /// <param name="point">Where it is on the ellipsoid.</param>
    /// <param name="altitude">How far above mean sea level.</param>
    public GeodeticPosition(GeographicPoint point, AmslAltitude altitude)
        : this(point.Latitude.Radians, point.Longitude.Radians, altitude.Metres)
    {
    }

    private GeodeticPosition(double latitudeRadians, double longitudeRadians, double altitudeAmslMetres)
        => (LatitudeRadians, LongitudeRadians, AltitudeAmslMetres) = (latitudeRadians, longitudeRadians, altitudeAmslMetres);

    /// <summary>-pi/2 to pi/2, north positive.</summary>
    public double LatitudeRadians { get; }

    /// <summary>-pi to pi, east positive.</summary>
    public double LongitudeRadians { get; }

    /// <summary>Above mean sea level, up positive.</summary>
    public double AltitudeAmslMetres { get; }

    /// <summary>Without its altitude.</summary>
    public GeographicPoint Point => new(Angle.FromRadians(LatitudeRadians), Angle.FromRadians(LongitudeRadians));

    /// <summary>Its altitude, as a type that is not mixed up with other heights.</summary>
    public AmslAltitude Altitude => new(AltitudeAmslMetres);

    /// <summary>From radians.</summary>
    /// <param name="latitudeRadians">-pi/2 to pi/2, north positive.</param>
    /// <param name="longitudeRadians">-pi to pi, east positive.</param>
    /// <param name="altitudeAmslMetres">Above mean sea level, up positive.</param>
    public static GeodeticPosition FromRadians(double latitudeRadians, double longitudeRadians, double altitudeAmslMetres)
        => new(latitudeRadians, longitudeRadians, altitudeAmslMetres);

    /// <summary>From degrees.</summary>
    /// <param name="latitudeDegrees">-90 to 90, north positive.</param>
    /// <param name="longitudeDegrees">-180 to 180, east positive.</param>
    /// <param name="altitudeAmslMetres">Above mean sea level, up positive.</param>
    public static GeodeticPosition FromDegrees(double latitudeDegrees, double longitudeDegrees, double altitudeAmslMetres)
        => new(Angle.FromDegrees(latitudeDegrees).Radians, Angle.FromDegrees(longitudeDegrees).Radians, altitudeAmslMetres);

    /// <summary>With its height above the ellipsoid.</summary>
    /// <param name="geoidUndulationMetres">How far the geoid is above the ellipsoid there, -107 to 86 m on earth.</param>
    public EllipsoidPosition ToEllipsoid(double geoidUndulationMetres) => new(Point, Altitude.ToEllipsoid(geoidUndulationMetres));
}
