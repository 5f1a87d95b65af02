using System;
using System.Numerics;

namespace Rabit.Vision;

/// <summary>Sums over the pixels of a form, for its <see cref="FormMoments"/>.</summary>
internal struct FormSums
{
    // Square pixels: what is thinner has no form.
    private const double MinSpread = 0.2;

    // A filled rectangle of area A has sigma_long * sigma_short = A / 12.
    private const double RectangleFactor = 12;

    private double _sum;
    private double _xx, _xy, _yy;
    private double _xxx, _xxy, _xyy, _yyy;
    private double _xxxx, _xxxy, _xxyy, _xyyy, _yyyy;

    /// <summary>Adds a pixel.</summary>
    /// <param name="x">Columns from the centre of the form.</param>
    /// <param name="y">Rows from the centre of the form.</param>
    /// <param name="part">Which part of it is covered.</param>
    public void Add(double x, double y, double part)
    {
        (double xx, double xy, double yy) = (part * x * x, part * x * y, part * y * y);
        _sum += part;
        (_xx, _xy, _yy) = (_xx + xx, _xy + xy, _yy + yy);
        (_xxx, _xxy, _xyy, _yyy) = (_xxx + (xx * x), _xxy + (xx * y), _xyy + (yy * x), _yyy + (yy * y));
        (_xxxx, _xxxy, _xxyy) = (_xxxx + (xx * x * x), _xxxy + (xx * x * y), _xxyy + (xx * y * y));
        (_xyyy, _yyyy) = (_xyyy + (xy * y * y), _yyyy + (yy * y * y));
    }

    /// <summary>The moments.</summary>
    /// <param name="blur">Variance of the blur in each direction, square pixels: it makes a form rounder.</param>
    public readonly FormMoments MomentsWithout(double blur)
    {
        if (!(_sum > 0))
            return default;

        // To a number p x + q y whose two parts have the same spread and nothing in common.
        double spreadX = Math.Max(MinSpread, (_xx / _sum) - blur);
        double slope = _xy / _sum / spreadX;
        double spreadY = Math.Max(MinSpread, (_yy / _sum) - blur - (slope * slope * spreadX));
        var q = new Complex(0, 1 / Math.Sqrt(2 * spreadY));
        Complex p = (1 / Math.Sqrt(2 * spreadX)) - (slope * q);
        Complex third = (p * p * p * _xxx) + (3 * p * p * q * _xxy) + (3 * p * q * q * _xyy) + (q * q * q * _yyy);
        Complex fourth = (p * p * p * p * _xxxx) + (4 * p * p * p * q * _xxxy) + (6 * p * p * q * q * _xxyy)
            + (4 * p * q * q * q * _xyyy) + (q * q * q * q * _yyyy);
        return new FormMoments
        {
            Fill = _sum / (RectangleFactor * Math.Sqrt(spreadX * spreadY)),
            Third = third.Magnitude / _sum,
            Fourth = fourth.Magnitude / _sum,
        };
    }
}
