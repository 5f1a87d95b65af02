using System;

namespace Rabit.Geodesy;

/// <summary>
/// Geodesics, the shortest lines on the WGS-84 ellipsoid, to some nanometres at any distance: nearly antipodal places,
/// poles and the date line are nothing special. Any thread; allocates nothing.
/// </summary>
/// <example>
/// <code>
/// var zurich = new GeographicPoint(Angle.FromDegrees(47.3769), Angle.FromDegrees(8.5417));
/// var bern = new GeographicPoint(Angle.FromDegrees(46.9480), Angle.FromDegrees(7.4474));
/// GeodesicLine line = Geodesic.Inverse(zurich, bern);
/// GeographicPoint halfWay = Geodesic.Direct(zurich, line.StartAzimuth, line.DistanceMetres / 2, out _);
/// </code>
/// </example>
/// <remarks>
/// Method: C. F. F. Karney, "Algorithms for geodesics", Journal of Geodesy 87 (2013), 43-55; the inverse problem by
/// Newton's method inside a bracket.
/// </remarks>
public static class Geodesic
{
    // Stands for 0 where its sign, or a division by it, matters.
    private const double Tiny = 1e-150;

    /// <summary>The direct problem: the place at a distance and azimuth from another.</summary>
    /// <param name="start">Where one begins.</param>
    /// <param name="azimuth">In which direction, clockwise from north.</param>
    /// <param name="distanceMetres">How far; negative for the other way.</param>
    /// <param name="endAzimuth">The direction there, going on, -180 to 180 degrees.</param>
    /// <exception cref="ArgumentException">Something is not a number, or the latitude is beyond a pole.</exception>
    public static GeographicPoint Direct(
        GeographicPoint start, Angle azimuth, double distanceMetres, out Angle endAzimuth)
    {
        Demand(start, nameof(start));
        if (!azimuth.IsFinite || double.IsNaN(distanceMetres) || double.IsInfinity(distanceMetres))
            throw new ArgumentException(
                FormattableString.Invariant($"The line of {distanceMetres} m at {azimuth} is not a number."),
                nameof(distanceMetres));
        (double sinAlpha, double cosAlpha) = (Trig.Sin(azimuth.Radians), Trig.Cos(azimuth.Radians));
        Reduce(start.Latitude.Radians, out double sinBeta, out double cosBeta);

        // The great circle of the auxiliary sphere, from where it crosses the equator going north.
        double sinAlpha0 = sinAlpha * cosBeta;
        double cosAlpha0 = Hypotenuse(cosAlpha, sinAlpha * sinBeta);
        (double sinSigma1, double cosSigma1) = Normal(sinBeta, sinBeta != 0 || cosAlpha != 0 ? cosAlpha * cosBeta : 1);
        double e = Expansion(cosAlpha0);
        GeodesicSeries distance = GeodesicSeries.Distance(e);
        double tau = Math.Atan2(sinSigma1, cosSigma1) + distance.Periodic(sinSigma1, cosSigma1)
            + (distanceMetres / (Wgs84.B * distance.Mean));
        double sigma2 = tau + GeodesicSeries.Arc(e).Periodic(Trig.Sin(tau), Trig.Cos(tau));
        (double sinSigma2, double cosSigma2) = (Trig.Sin(sigma2), Trig.Cos(sigma2));

        double sinBeta2 = cosAlpha0 * sinSigma2;
        double cosBeta2 = Hypotenuse(sinAlpha0, cosAlpha0 * cosSigma2);
        GeodesicSeries longitude = GeodesicSeries.Longitude(e);
        double sigma12 = sigma2 - Math.Atan2(sinSigma1, cosSigma1);
        double onSphere = Math.Atan2(sinAlpha0 * sinSigma2, cosSigma2) - Math.Atan2(sinAlpha0 * sinSigma1, cosSigma1);
        double turned = onSphere - (Wgs84.F * sinAlpha0 * longitude.Mean
            * (sigma12 + longitude.Periodic(sinSigma2, cosSigma2) - longitude.Periodic(sinSigma1, cosSigma1)));
        endAzimuth = Angle.FromRadians(Math.Atan2(sinAlpha0, cosAlpha0 * cosSigma2));
        return new GeographicPoint(
            Angle.FromRadians(Math.Atan2(sinBeta2, (1 - Wgs84.F) * cosBeta2)),
            Angle.FromRadians(start.Longitude.Radians + turned).Wrapped());
    }

    /// <summary>
    /// The inverse problem: the shortest line between two places. Where there are several of the same length, it is one
    /// of them.
    /// </summary>
    /// <param name="from">Where it begins.</param>
    /// <param name="to">Where it ends.</param>
    /// <exception cref="ArgumentException">Something is not a number, or a latitude is beyond a pole.</exception>
    public static GeodesicLine Inverse(GeographicPoint from, GeographicPoint to)
    {
        Demand(from, nameof(from));
        Demand(to, nameof(to));

        // To the one case from which the others follow by mirroring: the first place in the south and farther from the
        // equator, the line to the east.
        double lambda = DifferenceDegrees(from.Longitude.Degrees, to.Longitude.Degrees) * Angle.RadiansPerDegree;
        double eastward = lambda >= 0 ? 1 : -1;
        (double latitude1, double latitude2) = (from.Latitude.Radians, to.Latitude.Radians);
        double swap = Math.Abs(latitude1) < Math.Abs(latitude2) ? -1 : 1;
        if (swap < 0)
        {
            eastward = -eastward;
            (latitude1, latitude2) = (latitude2, latitude1);
        }

        double mirror = latitude1 < 0 ? 1 : -1;
        var problem = default(GeodesicProblem);
        Reduce(mirror * latitude1, out problem.SinBeta1, out problem.CosBeta1);
        Reduce(mirror * latitude2, out problem.SinBeta2, out problem.CosBeta2);
        if (problem.SinBeta1 == 0)
            problem.SinBeta1 = -Tiny;
        problem.MatchLatitudes();
        problem.Lambda = Math.Abs(lambda);
        double metres = problem.Solve();

        (double sin1, double cos1, double sin2, double cos2) =
            (problem.SinAlpha1, problem.CosAlpha1, problem.SinAlpha2, problem.CosAlpha2);
        if (swap < 0)
            (sin1, cos1, sin2, cos2) = (sin2, cos2, sin1, cos1);
        (double turnSin, double turnCos) = (swap * eastward, swap * mirror);
        return new GeodesicLine(
            metres, Angle.FromRadians(Math.Atan2(sin1 * turnSin, cos1 * turnCos)),
            Angle.FromRadians(Math.Atan2(sin2 * turnSin, cos2 * turnCos)));
    }

    /// <summary>
    /// From one longitude to another, -180 to 180 degrees, with the rounding of the sum added again: short lines keep
    /// their azimuth, also across the date line (Karney's AngDiff).
    /// </summary>
    internal static double DifferenceDegrees(double from, double to)
    {
        double a = Math.IEEERemainder(-from, 360);
        double b = Math.IEEERemainder(to, 360);
        double sum = a + b;
        double part = sum - a;
        double lost = (a - (sum - part)) + (b - part);
        return Math.IEEERemainder(sum, 360) + lost;
    }

    /// <summary>The parameter of the series, of the great circle's direction at the equator.</summary>
    internal static double Expansion(double cosAlpha0)
    {
        double k2 = cosAlpha0 * cosAlpha0 * Wgs84.SecondE2;
        return k2 / ((2 * (1 + Math.Sqrt(1 + k2))) + k2);
    }

    internal static double Hypotenuse(double a, double b) => Math.Sqrt((a * a) + (b * b));

    internal static (double Sin, double Cos) Normal(double sin, double cos)
    {
        double length = Hypotenuse(sin, cos);
        return (sin / length, cos / length);
    }

    private static void Reduce(double latitude, out double sinBeta, out double cosBeta)
    {
        (sinBeta, cosBeta) = Normal((1 - Wgs84.F) * Trig.Sin(latitude), Trig.Cos(latitude));

        // The cosine of a right angle is 6e-17 by rounding, or below 0.
        cosBeta = Math.Max(Tiny, Math.Abs(latitude) >= Math.PI / 2 ? 0 : cosBeta);
    }

    private static void Demand(GeographicPoint point, string parameter)
    {
        if (!(Math.Abs(point.Latitude.Radians) <= Math.PI / 2) || !point.Longitude.IsFinite)
            throw new ArgumentException($"{point.Latitude}, {point.Longitude} is no place on the earth.", parameter);
    }
}
