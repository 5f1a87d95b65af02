using System;

namespace Rabit.Geodesy;

/// <summary>
/// A flat north-east-down frame whose down is the WGS-84 ellipsoid's normal at an origin, through earth-centred
/// coordinates, so that it is exact at any distance. A plain value.
/// </summary>
/// <remarks>
/// Altitudes above mean sea level become heights above the ellipsoid by the undulation that the frame was given, and
/// only by that. Formulas: <see cref="Wgs84"/>.
/// </remarks>
/// <example>
/// <code>
/// GeodeticPosition home = GeodeticPosition.FromDegrees(47.3977, 8.5456, 488);
/// LocalNedFrame frame = LocalNedFrame.IgnoringGeoid(home);
/// NedPosition target = frame.ToNed(GeodeticPosition.FromDegrees(47.3980, 8.5460, 470));
/// NedVector fromHome = target - NedPosition.Origin;
/// Console.WriteLine($"{fromHome.HorizontalLength:0.0} m, bearing {fromHome.Azimuth.Degrees:0}°");
/// </code>
/// </example>
public readonly record struct LocalNedFrame
{
    private readonly double _sinLat;
    private readonly double _cosLat;
    private readonly double _sinLon;
    private readonly double _cosLon;
    private readonly double _x;
    private readonly double _y;
    private readonly double _z;

    /// <summary>Makes the frame.</summary>
    /// <param name="origin">Where north, east and down are 0.</param>
    /// <param name="geoidUndulationMetres">
    /// How far the geoid is above the ellipsoid in this frame, -107 to 86 m on earth.
    /// </param>
    public LocalNedFrame(GeodeticPosition origin, double geoidUndulationMetres)
    {
        Origin = origin;
        GeoidUndulationMetres = geoidUndulationMetres;
        (_sinLat, _cosLat) = (Trig.Sin(origin.Latitude.Radians), Trig.Cos(origin.Latitude.Radians));
        (_sinLon, _cosLon) = (Trig.Sin(origin.Longitude.Radians), Trig.Cos(origin.Longitude.Radians));
        (_x, _y, _z) = Wgs84.ToEarthCentred(
            origin.Latitude.Radians, origin.Longitude.Radians, origin.AltitudeAmslMetres + geoidUndulationMetres);
    }

    /// <summary>Makes the frame.</summary>
    /// <param name="origin">Where north, east and down are 0.</param>
    /// <param name="geoidUndulationMetres">
    /// How far the geoid is above the ellipsoid in this frame: for altitudes above mean sea level only.
    /// </param>
    public LocalNedFrame(EllipsoidPosition origin, double geoidUndulationMetres)
        : this(origin.ToAmsl(geoidUndulationMetres), geoidUndulationMetres)
    {
    }

    /// <summary>Makes the frame, with the undulation of the geoid at its origin.</summary>
    /// <param name="origin">Where north, east and down are 0.</param>
    /// <param name="geoid">How far the geoid is above the ellipsoid.</param>
    public LocalNedFrame(GeodeticPosition origin, GeoidGrid geoid)
        : this(origin, (geoid ?? throw new ArgumentNullException(nameof(geoid))).UndulationMetres(origin.Point))
    {
    }

    /// <summary>Makes the frame, with the undulation of the geoid at its origin.</summary>
    /// <param name="origin">Where north, east and down are 0.</param>
    /// <param name="geoid">How far the geoid is above the ellipsoid: for altitudes above mean sea level only.</param>
    public LocalNedFrame(EllipsoidPosition origin, GeoidGrid geoid)
        : this(origin, (geoid ?? throw new ArgumentNullException(nameof(geoid))).UndulationMetres(origin.Point))
    {
    }

    /// <summary>Where north, east and down are 0.</summary>
    public GeodeticPosition Origin { get; }

    /// <summary>How far the geoid is taken to be above the ellipsoid, metres.</summary>
    public double GeoidUndulationMetres { get; }

    /// <summary>
    /// The frame where the undulation is not known and need not be: mean sea level is taken for the ellipsoid, which
    /// stretches distances by 0.002 % at most. What goes in and out are altitudes above mean sea level; its heights
    /// above the ellipsoid mean nothing.
    /// </summary>
    /// <param name="origin">Where north, east and down are 0.</param>
    public static LocalNedFrame IgnoringGeoid(GeodeticPosition origin) => new(origin, geoidUndulationMetres: 0);

    /// <summary>A place in this frame, metres.</summary>
    /// <param name="position">The place.</param>
    public NedPosition ToNed(GeodeticPosition position)
        => FromEarthCentred(
            Wgs84.ToEarthCentred(
                position.Latitude.Radians, position.Longitude.Radians,
                position.AltitudeAmslMetres + GeoidUndulationMetres));

    /// <summary>A place in this frame, metres.</summary>
    /// <param name="position">The place.</param>
    public NedPosition ToNed(EllipsoidPosition position)
        => FromEarthCentred(
            Wgs84.ToEarthCentred(
                position.Point.Latitude.Radians, position.Point.Longitude.Radians, position.Height.Metres));

    /// <summary>The place of a point of this frame, with its altitude above mean sea level.</summary>
    /// <param name="ned">The point, metres.</param>
    public GeodeticPosition ToGeodetic(NedPosition ned)
    {
        (double latitude, double longitude, double height) = ToEllipsoidal(ned);
        return GeodeticPosition.FromRadians(latitude, longitude, height - GeoidUndulationMetres);
    }

    /// <summary>The place of a point of this frame, with its height above the ellipsoid.</summary>
    /// <param name="ned">The point, metres.</param>
    public EllipsoidPosition ToEllipsoid(NedPosition ned)
    {
        (double latitude, double longitude, double height) = ToEllipsoidal(ned);
        return new EllipsoidPosition(
            new GeographicPoint(Angle.FromRadians(latitude), Angle.FromRadians(longitude)),
            new EllipsoidHeight(height));
    }

    /// <summary>Its origin.</summary>
    public override string ToString() => $"north-east-down about {Origin}";

    private NedPosition FromEarthCentred((double X, double Y, double Z) place)
    {
        (double x, double y, double z) = (place.X - _x, place.Y - _y, place.Z - _z);
        double outward = (_cosLon * x) + (_sinLon * y);
        return new NedPosition(
            (-_sinLat * outward) + (_cosLat * z),
            (-_sinLon * x) + (_cosLon * y),
            (-_cosLat * outward) - (_sinLat * z));
    }

    private (double Latitude, double Longitude, double Height) ToEllipsoidal(NedPosition ned)
    {
        double outward = (-_sinLat * ned.North) - (_cosLat * ned.Down);
        double x = _x + (_cosLon * outward) - (_sinLon * ned.East);
        double y = _y + (_sinLon * outward) + (_cosLon * ned.East);
        double z = _z + (_cosLat * ned.North) - (_sinLat * ned.Down);
        return Wgs84.FromEarthCentred(x, y, z);
    }
}
