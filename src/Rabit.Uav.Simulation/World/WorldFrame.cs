using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Puts the flat world (north, east, down in metres, origin at home) onto the WGS-84 ellipsoid and back. It is
/// written apart from <see cref="LocalNedFrame"/> on purpose, so that an error there cannot cancel: differences of
/// latitude and longitude instead of earth-centred coordinates, and an iteration instead of a closed formula for the
/// way back. Altitudes are taken for heights above the ellipsoid.
/// </summary>
internal sealed class WorldFrame
{
    // WGS-84: semi-major axis, first eccentricity squared (NIMA TR8350.2, table 3.1 and 3.3).
    private const double SemiMajorAxis = 6_378_137.0;
    private const double EccentricitySquared = 6.694_379_990_141_32e-3;
    private const int Passes = 8;

    private readonly double _sin;
    private readonly double _cos;
    private readonly double _normal;

    public WorldFrame(GeodeticPosition origin)
    {
        Origin = origin;
        _sin = Trig.Sin(origin.Latitude.Radians);
        _cos = Trig.Cos(origin.Latitude.Radians);
        _normal = NormalRadius(_sin);
    }

    public GeodeticPosition Origin { get; }

    /// <summary>A place in the world, metres.</summary>
    public NedVector ToWorld(GeodeticPosition place)
    {
        double sin = Trig.Sin(place.Latitude.Radians);
        double cos = Trig.Cos(place.Latitude.Radians);
        double east = place.Longitude.Radians - Origin.Longitude.Radians;
        double normal = NormalRadius(sin);
        double radius = normal + place.AltitudeAmslMetres;
        double correction = EccentricitySquared * ((_normal * _sin) - (normal * sin));
        double up = (radius * ((_cos * cos * Trig.Cos(east)) + (_sin * sin))) + (_sin * correction)
            - (_normal + Origin.AltitudeAmslMetres);
        double north = (radius * ((_cos * sin) - (_sin * cos * Trig.Cos(east)))) + (_cos * correction);
        return new NedVector(north, radius * cos * Trig.Sin(east), -up);
    }

    /// <summary>The place of a point of the world.</summary>
    public GeodeticPosition ToPlace(NedVector point)
    {
        double latitude = Origin.Latitude.Radians;
        double longitude = Origin.Longitude.Radians;
        double altitude = Origin.AltitudeAmslMetres;
        NedVector missing = point;
        for (int pass = 0; pass < Passes; pass++)
        {
            // Each pass leaves about distance / earth radius of the error before it: eight are enough for any flight.
            double sin = Trig.Sin(latitude);
            double normal = NormalRadius(sin);
            double meridian = normal * (1 - EccentricitySquared) / (1 - (EccentricitySquared * sin * sin));
            latitude += missing.North / (meridian + altitude);
            longitude += missing.East / ((normal + altitude) * Trig.Cos(latitude));
            altitude -= missing.Down;
            NedVector reached = ToWorld(GeodeticPosition.FromRadians(latitude, longitude, altitude));
            missing = point.Minus(reached);
        }

        return GeodeticPosition.FromRadians(latitude, Math.IEEERemainder(longitude, 2 * Math.PI), altitude);
    }

    private static double NormalRadius(double sin) => SemiMajorAxis / Math.Sqrt(1 - (EccentricitySquared * sin * sin));
}
