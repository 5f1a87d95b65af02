using System;

namespace Rabit.Uav.Geometry;

/// <summary>
/// A flat north-east-down frame that touches the WGS-84 ellipsoid's normal at an origin, through earth-centred coordinates, so that it is
/// exact at any distance. A plain value.
/// </summary>
/// <remarks>
/// Altitudes are taken for heights above the ellipsoid, which moves everything by the same geoid undulation (at most 0.002 % of a distance).
/// Formulas: <see cref="Wgs84"/>.
/// </remarks>
public readonly struct LocalNedFrame
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
    public LocalNedFrame(GeodeticPosition origin)
    {
        Origin = origin;
        (_sinLat, _cosLat) = (Math.Sin(origin.LatitudeRadians), Math.Cos(origin.LatitudeRadians));
        (_sinLon, _cosLon) = (Math.Sin(origin.LongitudeRadians), Math.Cos(origin.LongitudeRadians));
        (_x, _y, _z) = ToEarthCentred(origin);
    }

    /// <summary>Where north, east and down are 0.</summary>
    public GeodeticPosition Origin { get; }

    /// <summary>A place in this frame, metres.</summary>
    /// <param name="position">The place.</param>
    public NedVector ToNed(GeodeticPosition position)
    {
        (double x, double y, double z) = ToEarthCentred(position);
        (x, y, z) = (x - _x, y - _y, z - _z);
        double outward = (_cosLon * x) + (_sinLon * y);
        return new NedVector(
            (-_sinLat * outward) + (_cosLat * z),
            (-_sinLon * x) + (_cosLon * y),
            (-_cosLat * outward) - (_sinLat * z));
    }

    /// <summary>The place of a point of this frame.</summary>
    /// <param name="ned">The point, metres.</param>
    public GeodeticPosition ToGeodetic(NedVector ned)
    {
        double outward = (-_sinLat * ned.North) - (_cosLat * ned.Down);
        double x = _x + (_cosLon * outward) - (_sinLon * ned.East);
        double y = _y + (_sinLon * outward) + (_cosLon * ned.East);
        double z = _z + (_cosLat * ned.North) - (_sinLat * ned.Down);
        return FromEarthCentred(x, y, z);
    }

    private static (double X, double Y, double Z) ToEarthCentred(GeodeticPosition p)
        => Wgs84.ToEarthCentred(p.LatitudeRadians, p.LongitudeRadians, p.AltitudeAmslMetres);

    private static GeodeticPosition FromEarthCentred(double x, double y, double z)
    {
        (double latitude, double longitude, double height) = Wgs84.FromEarthCentred(x, y, z);
        return new GeodeticPosition(latitude, longitude, height);
    }
}
