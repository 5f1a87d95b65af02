using System;

namespace Rabit.Geodesy;

/// <summary>A place on the WGS-84 ellipsoid with its altitude above mean sea level. A plain value.</summary>
/// <remarks>
/// Made from things that know their unit and their datum, or from numbers by a method that names the unit; never from
/// bare numbers.
/// </remarks>
/// <example>
/// <code>
/// GeodeticPosition home = GeodeticPosition.FromDegrees(47.3977, 8.5456, altitudeAmslMetres: 488);
/// LocalNedFrame frame = LocalNedFrame.IgnoringGeoid(home);
/// GeodeticPosition north = frame.ToGeodetic(new NedPosition(100, 0, 0));   // 100 m north of home
/// </code>
/// </example>
public readonly record struct GeodeticPosition
{
    private readonly double _latitude;
    private readonly double _longitude;

    /// <summary>Makes it.</summary>
    /// <param name="point">Where it is on the ellipsoid.</param>
    /// <param name="altitude">How far above mean sea level.</param>
    public GeodeticPosition(GeographicPoint point, AmslAltitude altitude)
        : this(point.Latitude.Radians, point.Longitude.Radians, altitude.Metres)
    {
    }

    private GeodeticPosition(double latitudeRadians, double longitudeRadians, double altitudeAmslMetres)
        => (_latitude, _longitude, AltitudeAmslMetres) = (latitudeRadians, longitudeRadians, altitudeAmslMetres);

    /// <summary>-90 to 90 degrees, north positive.</summary>
    public Angle Latitude => Angle.FromRadians(_latitude);

    /// <summary>-180 to 180 degrees, east positive.</summary>
    public Angle Longitude => Angle.FromRadians(_longitude);

    /// <summary>Above mean sea level, up positive.</summary>
    public double AltitudeAmslMetres { get; }

    /// <summary>Without its altitude.</summary>
    public GeographicPoint Point => new(Latitude, Longitude);

    /// <summary>Its altitude, as a type that is not mixed up with other heights.</summary>
    public AmslAltitude Altitude => new(AltitudeAmslMetres);

    /// <summary>From radians.</summary>
    /// <param name="latitudeRadians">-pi/2 to pi/2, north positive.</param>
    /// <param name="longitudeRadians">-pi to pi, east positive.</param>
    /// <param name="altitudeAmslMetres">Above mean sea level, up positive.</param>
    public static GeodeticPosition FromRadians(
        double latitudeRadians, double longitudeRadians, double altitudeAmslMetres)
        => new(latitudeRadians, longitudeRadians, altitudeAmslMetres);

    /// <summary>From degrees.</summary>
    /// <param name="latitudeDegrees">-90 to 90, north positive.</param>
    /// <param name="longitudeDegrees">-180 to 180, east positive.</param>
    /// <param name="altitudeAmslMetres">Above mean sea level, up positive.</param>
    public static GeodeticPosition FromDegrees(
        double latitudeDegrees, double longitudeDegrees, double altitudeAmslMetres)
        => new(latitudeDegrees * Angle.RadiansPerDegree, longitudeDegrees * Angle.RadiansPerDegree, altitudeAmslMetres);

    /// <summary>
    /// Whether it is on the earth: a latitude from pole to pole, and numbers everywhere. Not every value is checked
    /// when it is made.
    /// </summary>
    public bool IsValid => Point.IsValid && FiniteNumbers.IsFinite(AltitudeAmslMetres);

    /// <summary>With its height above the ellipsoid.</summary>
    /// <param name="geoidUndulationMetres">
    /// How far the geoid is above the ellipsoid there, -107 to 86 m on earth.
    /// </param>
    public EllipsoidPosition ToEllipsoid(double geoidUndulationMetres)
        => new(Point, Altitude.ToEllipsoid(geoidUndulationMetres));

    /// <summary>With its height above the ellipsoid.</summary>
    /// <param name="geoid">How far the geoid is above the ellipsoid.</param>
    public EllipsoidPosition ToEllipsoid(GeoidGrid geoid)
        => ToEllipsoid((geoid ?? throw new ArgumentNullException(nameof(geoid))).UndulationMetres(Point));

    /// <summary>In decimal degrees and metres.</summary>
    public override string ToString() => $"{Point}, {Altitude}";
}
