using System;

namespace Rabit.Geodesy;

/// <summary>
/// The inverse problem of geodesics in its one form, on the auxiliary sphere: the first place in the south and at least
/// as far from the equator as the second, the line to the east. See <see cref="Geodesic"/>. A plain value that is
/// solved once.
/// </summary>
internal struct GeodesicProblem
{
    public double SinBeta1;
    public double CosBeta1;
    public double SinBeta2;
    public double CosBeta2;

    /// <summary>Difference of the longitudes, 0 to pi.</summary>
    public double Lambda;

    public double SinAlpha1;
    public double CosAlpha1;
    public double SinAlpha2;
    public double CosAlpha2;

    private const int MaxSteps = 120;
    private const double Good = 1e-16;
    private const double Tiny = 1e-150;

    // The arc, where it begins and ends, and how its longitude grows with the first azimuth.
    private double _sinSigma1;
    private double _cosSigma1;
    private double _sinSigma2;
    private double _cosSigma2;
    private double _sigma12;
    private double _e;
    private double _growth;

    /// <summary>Latitudes that are alike but for rounding are made alike: their squares are subtracted.</summary>
    public void MatchLatitudes()
    {
        if (CosBeta1 < -SinBeta1)
        {
            if (CosBeta2 == CosBeta1)
                SinBeta2 = SinBeta2 < 0 ? SinBeta1 : -SinBeta1;
        }
        else if (Math.Abs(SinBeta2) == -SinBeta1)
        {
            CosBeta2 = CosBeta1;
        }
    }

    /// <summary>The length of the line, metres; the azimuths are in the fields.</summary>
    public double Solve()
    {
        if (CosBeta1 <= Tiny || Lambda == 0 || Lambda >= Math.PI)
            return AlongMeridian();
        if (SinBeta1 >= -Tiny && Lambda <= (1 - Wgs84.F) * Math.PI)
        {
            (SinAlpha1, CosAlpha1, SinAlpha2, CosAlpha2) = (1, 0, 1, 0);
            return Wgs84.A * Lambda;
        }

        Guess();
        Refine();
        return Length();
    }

    private double AlongMeridian()
    {
        // The sine of pi, as a number, is not 0.
        (SinAlpha1, CosAlpha1) = (Lambda >= Math.PI ? 0 : Trig.Sin(Lambda), Trig.Cos(Lambda));
        (SinAlpha2, CosAlpha2) = (0, 1);
        (_sinSigma1, _cosSigma1) = Geodesic.Normal(SinBeta1, (CosAlpha1 < 0 ? -1 : 1) * CosBeta1);
        (_sinSigma2, _cosSigma2) = Geodesic.Normal(SinBeta2, CosBeta2);
        if (CosBeta1 <= Tiny)
            _cosSigma1 = Tiny;
        _sigma12 = Math.Atan2(
            Math.Max(0, (_cosSigma1 * _sinSigma2) - (_sinSigma1 * _cosSigma2)),
            (_cosSigma1 * _cosSigma2) + (_sinSigma1 * _sinSigma2));
        _e = Geodesic.Expansion(1);
        return Length();
    }

    // The great circle, with the longitude that belongs to it about in the middle.
    private void Guess()
    {
        double cosMiddle = (CosBeta1 + CosBeta2) / 2;
        double omega = Math.Min(Lambda / Math.Sqrt(1 - (Wgs84.E2 * cosMiddle * cosMiddle)), Math.PI);
        double half = Trig.Sin(omega / 2);
        double sinDifference = (SinBeta2 * CosBeta1) - (CosBeta2 * SinBeta1);
        double sinSum = (SinBeta2 * CosBeta1) + (CosBeta2 * SinBeta1);
        double y = CosBeta2 * Trig.Sin(omega);
        double x = Trig.Cos(omega) >= 0
            ? sinDifference + (2 * CosBeta2 * SinBeta1 * half * half)
            : sinSum - (2 * CosBeta2 * SinBeta1 * Trig.Cos(omega / 2) * Trig.Cos(omega / 2));
        (SinAlpha1, CosAlpha1) = y > 0 || x != 0 ? Geodesic.Normal(Math.Max(y, Tiny), x) : (1, 0);
    }

    // The longitude grows with the first azimuth all the way: Newton's steps, and halves where they leave the bracket.
    private void Refine()
    {
        (double lowSin, double lowCos) = (Tiny, 1.0);
        (double highSin, double highCos) = (Tiny, -1.0);
        for (int step = 0; step < MaxSteps; step++)
        {
            double miss = LongitudeAt() - Lambda;
            if (Math.Abs(miss) <= Good)
                return;
            if (miss > 0)
                (highSin, highCos) = (SinAlpha1, CosAlpha1);
            else
                (lowSin, lowCos) = (SinAlpha1, CosAlpha1);
            double turn = _growth > 0 ? -miss / _growth : double.NaN;
            (double sin, double cos) = Math.Abs(turn) < 1
                ? Geodesic.Normal(
                    (SinAlpha1 * Trig.Cos(turn)) + (CosAlpha1 * Trig.Sin(turn)),
                    (CosAlpha1 * Trig.Cos(turn)) - (SinAlpha1 * Trig.Sin(turn)))
                : (-1, 0);
            bool isInside = sin > 0 && (lowCos * sin) - (lowSin * cos) > 0 && (cos * highSin) - (sin * highCos) > 0;
            if (!isInside)
                (sin, cos) = Middle(lowSin, lowCos, highSin, highCos);
            if (sin == SinAlpha1 && cos == CosAlpha1)
                return;
            (SinAlpha1, CosAlpha1) = (sin, cos);
        }

        LongitudeAt();
    }

    // Half way between two directions that may be opposite.
    private static (double Sin, double Cos) Middle(double lowSin, double lowCos, double highSin, double highCos)
    {
        (double sin, double cos) = (lowSin + highSin, lowCos + highCos);
        return Geodesic.Hypotenuse(sin, cos) < 1e-8 ? (1, 0) : Geodesic.Normal(sin, cos);
    }

    // How far east the great circle with the first azimuth comes until the second latitude (Karney's equations 5, 8,
    // 11, 12, 45, 46).
    private double LongitudeAt()
    {
        double sinAlpha0 = SinAlpha1 * CosBeta1;
        double cosAlpha0 = Geodesic.Hypotenuse(CosAlpha1, SinAlpha1 * SinBeta1);
        bool isSame = CosBeta2 == CosBeta1;
        SinAlpha2 = isSame ? SinAlpha1 : sinAlpha0 / CosBeta2;
        double squares = CosBeta1 < -SinBeta1
            ? (CosBeta2 - CosBeta1) * (CosBeta1 + CosBeta2)
            : (SinBeta1 - SinBeta2) * (SinBeta1 + SinBeta2);
        CosAlpha2 = isSame && Math.Abs(SinBeta2) == -SinBeta1
            ? Math.Abs(CosAlpha1)
            : Math.Sqrt(Math.Max(0, (CosAlpha1 * CosBeta1 * CosAlpha1 * CosBeta1) + squares)) / CosBeta2;
        (double x1, double x2) = (CosAlpha1 * CosBeta1, CosAlpha2 * CosBeta2);
        (_sinSigma1, _cosSigma1) = Geodesic.Normal(SinBeta1, x1);
        (_sinSigma2, _cosSigma2) = Geodesic.Normal(SinBeta2, x2);
        _sigma12 = Math.Atan2(
            Math.Max(0, (_cosSigma1 * _sinSigma2) - (_sinSigma1 * _cosSigma2)),
            (_cosSigma1 * _cosSigma2) + (_sinSigma1 * _sinSigma2));
        (double sinOmega1, double cosOmega1) = Geodesic.Normal(sinAlpha0 * SinBeta1, x1);
        (double sinOmega2, double cosOmega2) = Geodesic.Normal(sinAlpha0 * SinBeta2, x2);
        double omega12 = Math.Atan2(
            Math.Max(0, (cosOmega1 * sinOmega2) - (sinOmega1 * cosOmega2)),
            (cosOmega1 * cosOmega2) + (sinOmega1 * sinOmega2));
        _e = Geodesic.Expansion(cosAlpha0);
        GeodesicSeries longitude = GeodesicSeries.Longitude(_e);
        double periodic = longitude.Periodic(_sinSigma2, _cosSigma2) - longitude.Periodic(_sinSigma1, _cosSigma1);
        _growth = Growth(cosAlpha0);
        return omega12 - (Wgs84.F * sinAlpha0 * longitude.Mean * (_sigma12 + periodic));
    }

    private readonly double Growth(double cosAlpha0)
    {
        double k2 = cosAlpha0 * cosAlpha0 * Wgs84.SecondE2;
        double stretch1 = Math.Sqrt(1 + (k2 * _sinSigma1 * _sinSigma1));
        if (CosAlpha2 <= 0)
            return -2 * (1 - Wgs84.F) * stretch1 / SinBeta1;
        double stretch2 = Math.Sqrt(1 + (k2 * _sinSigma2 * _sinSigma2));
        GeodesicSeries distance = GeodesicSeries.Distance(_e);
        GeodesicSeries reduced = GeodesicSeries.ReducedLength(_e);
        double j = ((distance.Mean - reduced.Mean) * _sigma12)
            + (distance.Mean * (distance.Periodic(_sinSigma2, _cosSigma2) - distance.Periodic(_sinSigma1, _cosSigma1)))
            - (reduced.Mean * (reduced.Periodic(_sinSigma2, _cosSigma2) - reduced.Periodic(_sinSigma1, _cosSigma1)));
        double m = (stretch2 * _cosSigma1 * _sinSigma2) - (stretch1 * _sinSigma1 * _cosSigma2)
            - (_cosSigma1 * _cosSigma2 * j);
        return m * (1 - Wgs84.F) / (CosAlpha2 * CosBeta2);
    }

    private readonly double Length()
    {
        GeodesicSeries distance = GeodesicSeries.Distance(_e);
        return Wgs84.B * distance.Mean
            * (_sigma12 + distance.Periodic(_sinSigma2, _cosSigma2) - distance.Periodic(_sinSigma1, _cosSigma1));
    }
}
