namespace Rabit.Geodesy;

/// <summary>
/// The series of C. F. F. Karney, "Algorithms for geodesics", Journal of Geodesy 87 (2013), equations 15 to 25, 41 to
/// 43, to the sixth order: some nanometres over half the earth. Each is a mean value and the coefficients of sin 2
/// sigma, sin 4 sigma, and so on. A plain value.
/// </summary>
internal readonly struct GeodesicSeries
{
    private readonly double _c1;
    private readonly double _c2;
    private readonly double _c3;
    private readonly double _c4;
    private readonly double _c5;
    private readonly double _c6;

    private GeodesicSeries(double mean, double c1, double c2, double c3, double c4, double c5, double c6)
    {
        Mean = mean;
        (_c1, _c2, _c3, _c4, _c5, _c6) = (c1, c2, c3, c4, c5, c6);
    }

    public double Mean { get; }

    /// <summary>Distance by arc (17, 18).</summary>
    public static GeodesicSeries Distance(double e)
    {
        double e2 = e * e;
        return new GeodesicSeries(
            (1 + (e2 * ((1.0 / 4) + (e2 * ((1.0 / 64) + (e2 / 256)))))) / (1 - e),
            e * ((-1.0 / 2) + (e2 * ((3.0 / 16) - (e2 / 32)))),
            e2 * ((-1.0 / 16) + (e2 * ((1.0 / 32) - (e2 * 9 / 2048)))),
            e2 * e * ((-1.0 / 48) + (e2 * 3 / 256)),
            e2 * e2 * ((-5.0 / 512) + (e2 * 3 / 512)),
            e2 * e2 * e * (-7.0 / 1280),
            e2 * e2 * e2 * (-7.0 / 2048));
    }

    /// <summary>Arc by distance (21).</summary>
    public static GeodesicSeries Arc(double e)
    {
        double e2 = e * e;
        return new GeodesicSeries(
            0,
            e * ((1.0 / 2) + (e2 * ((-9.0 / 32) + (e2 * 205 / 1536)))),
            e2 * ((5.0 / 16) + (e2 * ((-37.0 / 96) + (e2 * 1335 / 4096)))),
            e2 * e * ((29.0 / 96) - (e2 * 75 / 128)),
            e2 * e2 * ((539.0 / 1536) - (e2 * 2391 / 2560)),
            e2 * e2 * e * (3467.0 / 7680),
            e2 * e2 * e2 * (38081.0 / 61440));
    }

    /// <summary>The part of the reduced length beside the distance (42, 43).</summary>
    public static GeodesicSeries ReducedLength(double e)
    {
        double e2 = e * e;
        return new GeodesicSeries(
            (1 - e) * (1 + (e2 * ((1.0 / 4) + (e2 * ((9.0 / 64) + (e2 * 25 / 256)))))),
            e * ((1.0 / 2) + (e2 * ((1.0 / 16) + (e2 / 32)))),
            e2 * ((3.0 / 16) + (e2 * ((1.0 / 32) + (e2 * 35 / 2048)))),
            e2 * e * ((5.0 / 48) + (e2 * 5 / 256)),
            e2 * e2 * ((35.0 / 512) + (e2 * 7 / 512)),
            e2 * e2 * e * (63.0 / 1280),
            e2 * e2 * e2 * (77.0 / 2048));
    }

    /// <summary>Longitude by arc (24, 25), for the flattening of WGS-84.</summary>
    public static GeodesicSeries Longitude(double e)
    {
        const double N = Wgs84.N;
        const double N2 = N * N;
        double e2 = e * e;
        double e3 = e2 * e;
        double e4 = e2 * e2;
        double e5 = e4 * e;
        return new GeodesicSeries(
            1 - (((1 - N) / 2) * e) - (((1.0 / 4) + (N / 8) - (3 * N2 / 8)) * e2)
                - (((1.0 / 16) + (3 * N / 16) + (N2 / 16)) * e3)
                - (((3.0 / 64) + (N / 32)) * e4) - (e5 * 3 / 128),
            (((1 - N) / 4) * e) + (((1 - N2) / 8) * e2) + (((3.0 / 64) + (3 * N / 64) - (N2 / 64)) * e3)
                + (((5.0 / 128) + (N / 64)) * e4) + (e5 * 3 / 128),
            (((1.0 / 16) - (3 * N / 32) + (N2 / 32)) * e2) + (((3.0 / 64) - (N / 32) - (3 * N2 / 64)) * e3)
                + (((3.0 / 128) + (N / 128)) * e4) + (e5 * 5 / 256),
            (((5.0 / 192) - (3 * N / 64) + (5 * N2 / 192)) * e3) + (((3.0 / 128) - (5 * N / 192)) * e4)
                + (e5 * 7 / 512),
            (((7.0 / 512) - (7 * N / 256)) * e4) + (e5 * 7 / 512),
            e5 * 21 / 2560,
            0);
    }

    /// <summary>The periodic part at an angle, by Clenshaw's summation.</summary>
    public double Periodic(double sin, double cos)
    {
        double x = 2 * (cos - sin) * (cos + sin);
        double b6 = _c6;
        double b5 = (x * b6) + _c5;
        double b4 = (x * b5) - b6 + _c4;
        double b3 = (x * b4) - b5 + _c3;
        double b2 = (x * b3) - b4 + _c2;
        double b1 = (x * b2) - b3 + _c1;
        return 2 * sin * cos * b1;
    }
}
