using System;

namespace Rabit.Geodesy;

/// <summary>
/// The transverse Mercator projection of WGS-84 about a central meridian, scale 1 on it, by Krüger's series to the
/// sixth order: a few nanometres within 3900 km of the meridian. Radians and metres.
/// </summary>
/// <remarks>
/// Formulas: C. F. F. Karney, "Transverse Mercator with an accuracy of a few nanometers", Journal of Geodesy 85 (2011),
/// equations 7 to 26, 35, 36.
/// </remarks>
internal static class TransverseMercator
{
    private const double N = Wgs84.N;
    private const double N2 = N * N;
    private const double N3 = N2 * N;
    private const double N4 = N2 * N2;
    private const double N5 = N4 * N;
    private const double N6 = N3 * N3;

    // Length of a quarter of a meridian, by pi/2.
    private const double Radius = Wgs84.A / (1 + N) * (1 + (N2 / 4) + (N4 / 64) + (N6 / 256));

    private static readonly double E = Math.Sqrt(Wgs84.E2);

    private static readonly double[] Forward =
    [
        (N / 2) - (N2 * 2 / 3) + (N3 * 5 / 16) + (N4 * 41 / 180) - (N5 * 127 / 288) + (N6 * 7891 / 37800),
        (N2 * 13 / 48) - (N3 * 3 / 5) + (N4 * 557 / 1440) + (N5 * 281 / 630) - (N6 * 1983433 / 1935360),
        (N3 * 61 / 240) - (N4 * 103 / 140) + (N5 * 15061 / 26880) + (N6 * 167603 / 181440),
        (N4 * 49561 / 161280) - (N5 * 179 / 168) + (N6 * 6601661 / 7257600),
        (N5 * 34729 / 80640) - (N6 * 3418889 / 1995840),
        N6 * 212378941 / 319334400,
    ];

    private static readonly double[] Backward =
    [
        (N / 2) - (N2 * 2 / 3) + (N3 * 37 / 96) - (N4 / 360) - (N5 * 81 / 512) + (N6 * 96199 / 604800),
        (N2 / 48) + (N3 / 15) - (N4 * 437 / 1440) + (N5 * 46 / 105) - (N6 * 1118711 / 3870720),
        (N3 * 17 / 480) - (N4 * 37 / 840) - (N5 * 209 / 4480) + (N6 * 5569 / 90720),
        (N4 * 4397 / 161280) - (N5 * 11 / 504) - (N6 * 830251 / 7257600),
        (N5 * 4583 / 161280) - (N6 * 108847 / 3991680),
        N6 * 20648693 / 638668800,
    ];

    public static void Project(
        double latitude, double longitude, out double x, out double y, out double convergence, out double scale)
    {
        double tau = Math.Tan(latitude);
        double conformal = Conformal(tau);
        (double sinLon, double cosLon) = (Trig.Sin(longitude), Trig.Cos(longitude));
        double length = Geodesic.Hypotenuse(conformal, cosLon);
        double xi = Math.Atan2(conformal, cosLon);
        double eta = AreaSinh(sinLon / length);
        (double north, double east) = (xi, eta);
        (double p, double q) = (1, 0);
        for (int j = 1; j <= 6; j++)
        {
            double a = Forward[j - 1];
            (double sin, double cos) = (Trig.Sin(2 * j * xi), Trig.Cos(2 * j * xi));
            (double sinh, double cosh) = (Math.Sinh(2 * j * eta), Math.Cosh(2 * j * eta));
            north += a * sin * cosh;
            east += a * cos * sinh;
            p += 2 * j * a * cos * cosh;
            q += 2 * j * a * sin * sinh;
        }

        x = Radius * east;
        y = Radius * north;
        convergence = Math.Atan2(conformal * sinLon, cosLon * Geodesic.Hypotenuse(1, conformal)) + Math.Atan2(q, p);
        double sinLat = Trig.Sin(latitude);
        scale = Radius / Wgs84.A * Geodesic.Hypotenuse(p, q)
            * Math.Sqrt(1 - (Wgs84.E2 * sinLat * sinLat)) * Geodesic.Hypotenuse(1, tau) / length;
    }

    public static void Unproject(double x, double y, out double latitude, out double longitude)
    {
        double north = y / Radius;
        double east = x / Radius;
        (double xi, double eta) = (north, east);
        for (int j = 1; j <= 6; j++)
        {
            xi -= Backward[j - 1] * Trig.Sin(2 * j * north) * Math.Cosh(2 * j * east);
            eta -= Backward[j - 1] * Trig.Cos(2 * j * north) * Math.Sinh(2 * j * east);
        }

        double sinh = Math.Sinh(eta);
        double cos = Trig.Cos(xi);
        longitude = Math.Atan2(sinh, cos);
        latitude = Math.Atan(FromConformal(Trig.Sin(xi) / Geodesic.Hypotenuse(sinh, cos)));
    }

    // Tangent of the conformal latitude of a tangent of the latitude.
    private static double Conformal(double tau)
    {
        double secant = Geodesic.Hypotenuse(1, tau);
        double sigma = Math.Sinh(E * AreaTanh(E * tau / secant));
        return (tau * Geodesic.Hypotenuse(1, sigma)) - (sigma * secant);
    }

    private static double FromConformal(double conformal)
    {
        double tau = conformal / (1 - Wgs84.E2);
        for (int step = 0; step < 5; step++)
        {
            double at = Conformal(tau);
            double change = (conformal - at) / Geodesic.Hypotenuse(1, at)
                * (1 + ((1 - Wgs84.E2) * tau * tau)) / ((1 - Wgs84.E2) * Geodesic.Hypotenuse(1, tau));
            tau += change;
            if (Math.Abs(change) <= 1e-16 * Math.Max(1, Math.Abs(tau)))
                break;
        }

        return tau;
    }

    private static double AreaTanh(double x) => 0.5 * Math.Log((1 + x) / (1 - x));

    private static double AreaSinh(double x) => x < 0 ? -AreaSinh(-x) : Math.Log(x + Geodesic.Hypotenuse(x, 1));
}
