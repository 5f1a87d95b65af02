using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;

namespace Rabit.Tool.Geolocation;

/// <summary>
/// The edge of a 95 % ellipse as rings of GeoJSON: counter-clockwise, closed, and cut where it crosses the 180th
/// meridian.
/// </summary>
internal static class EllipseRing
{
    private const int Steps = 48;
    private const double MaxMetres = 100_000;
    private const double HalfTurnDegrees = 180;
    private const double TurnDegrees = 360;

    /// <returns>
    /// One ring, two of an ellipse on both sides of the meridian, none where it is no area or holds a pole.
    /// </returns>
    public static IReadOnlyList<IReadOnlyList<(double Longitude, double Latitude)>> Of(
        GeodeticPosition centre, HorizontalCovariance covariance)
    {
        (double major, double minor) = (covariance.HalfMajorAxis95Metres, covariance.HalfMinorAxis95Metres);
        if (!(major > 0 && major < MaxMetres && minor > 0))
            return [];
        double middle = centre.Longitude.Degrees;
        (double Longitude, double Latitude)[] edge =
        [
            .. Edge(centre, major, minor, covariance.MajorAxis.Radians).Select(p =>
            {
                double longitude = p.Longitude.Degrees;
                return (longitude - (TurnDegrees * Math.Round((longitude - middle) / TurnDegrees)), p.Latitude.Degrees);
            }),
        ];
        (double west, double east) = (edge.Min(p => p.Longitude), edge.Max(p => p.Longitude));
        if (east - west >= HalfTurnDegrees)
            return [];
        double cut = east > HalfTurnDegrees ? HalfTurnDegrees : -HalfTurnDegrees;
        IEnumerable<(double Longitude, double Latitude)[]> parts = west < cut && cut < east
            ? [Side(edge, cut, isEast: false), Side(edge, cut, isEast: true)]
            : [edge];
        return [.. parts.Where(p => p.Length > 2).Select(Closed)];
    }

    // Against the clock, seen from above.
    private static IEnumerable<GeodeticPosition> Edge(
        GeodeticPosition centre, double major, double minor, double direction)
    {
        var frame = LocalNedFrame.IgnoringGeoid(centre);
        (double cos, double sin) = (Math.Cos(direction), Math.Sin(direction));
        for (int step = 0; step < Steps; step++)
        {
            double angle = -2 * Math.PI * step / Steps;
            (double along, double across) = (major * Math.Cos(angle), minor * Math.Sin(angle));
            yield return frame.ToGeodetic(
                new NedPosition((along * cos) - (across * sin), (along * sin) + (across * cos), 0));
        }
    }

    // What of a convex ring is on one side of a meridian.
    private static (double Longitude, double Latitude)[] Side(
        (double Longitude, double Latitude)[] ring, double cut, bool isEast)
    {
        var side = new List<(double, double)>();
        for (int index = 0; index < ring.Length; index++)
        {
            (double Longitude, double Latitude) a = ring[index];
            (double Longitude, double Latitude) b = ring[(index + 1) % ring.Length];
            if (a.Longitude >= cut == isEast)
                side.Add(a);
            if (a.Longitude >= cut != b.Longitude >= cut)
            {
                double part = (cut - a.Longitude) / (b.Longitude - a.Longitude);
                side.Add((cut, a.Latitude + (part * (b.Latitude - a.Latitude))));
            }
        }

        double shift = isEast ? cut > 0 ? -TurnDegrees : 0 : cut < 0 ? TurnDegrees : 0;
        return [.. side.Select(p => (p.Item1 + shift, p.Item2))];
    }

    private static IReadOnlyList<(double Longitude, double Latitude)> Closed(
        (double Longitude, double Latitude)[] ring) => [.. ring, ring[0]];
}
