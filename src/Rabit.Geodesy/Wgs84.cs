using System;

namespace Rabit.Geodesy;

/// <summary>
/// The WGS-84 ellipsoid, and the way between latitude, longitude and height and earth-centred coordinates; radians and
/// metres.
/// </summary>
/// <remarks>
/// Formulas: NIMA TR8350.2, "Department of Defense World Geodetic System 1984", 4.3; the way back by Bowring, Survey
/// Review 23 (1976).
/// </remarks>
internal static class Wgs84
{
    public const double A = 6_378_137.0;
    public const double F = 1 / 298.257_223_563;
    public const double B = A * (1 - F);
    public const double E2 = F * (2 - F);

    /// <summary>The second eccentricity, squared.</summary>
    public const double SecondE2 = E2 / (1 - E2);

    /// <summary>The third flattening.</summary>
    public const double N = F / (2 - F);

    public static (double X, double Y, double Z) ToEarthCentred(double latitude, double longitude, double height)
    {
        double sin = Trig.Sin(latitude);
        double n = A / Math.Sqrt(1 - (E2 * sin * sin));
        double r = (n + height) * Trig.Cos(latitude);
        return (r * Trig.Cos(longitude), r * Trig.Sin(longitude), ((n * (1 - E2)) + height) * sin);
    }

    // Bowring's formula twice: below a nanometre anywhere near the earth's surface.
    public static (double Latitude, double Longitude, double Height) FromEarthCentred(double x, double y, double z)
    {
        double p = Math.Sqrt((x * x) + (y * y));
        double beta = Math.Atan2(z * A, p * B);
        double latitude = 0;
        for (int pass = 0; pass < 2; pass++)
        {
            (double sinBeta, double cosBeta) = (Trig.Sin(beta), Trig.Cos(beta));
            latitude = Math.Atan2(
                z + (SecondE2 * B * sinBeta * sinBeta * sinBeta), p - (E2 * A * cosBeta * cosBeta * cosBeta));
            beta = Math.Atan2((1 - F) * Trig.Sin(latitude), Trig.Cos(latitude));
        }

        double sin = Trig.Sin(latitude);
        double height = (p * Trig.Cos(latitude)) + (z * sin) - (A * Math.Sqrt(1 - (E2 * sin * sin)));
        return (latitude, Math.Atan2(y, x), height);
    }
}
