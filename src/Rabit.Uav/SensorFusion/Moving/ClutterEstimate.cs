using System;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>
/// How many points of a class are of no target, per square metre and scan: a mean at first, then a slow average. What
/// makes a start easy where there is no clutter, and hard where there is much. A plain value.
/// </summary>
internal struct ClutterEstimate
{
    private const double Share = 0.1;

    private readonly double _least;
    private int _scans;

    /// <summary>Starts without clutter.</summary>
    /// <param name="least">The density is never below this.</param>
    public ClutterEstimate(double least)
    {
        _least = least;
        Density = least;
    }

    /// <summary>Points per square metre and scan.</summary>
    public double Density { get; private set; }

    /// <summary>Takes a scan in.</summary>
    /// <param name="points">How many points of the class were of no track, as far as is known.</param>
    /// <param name="squareMetres">How much ground the scan showed; 0 where it is not known.</param>
    public void Add(double points, double squareMetres)
    {
        if (!(squareMetres > 0))
            return;
        _scans = Math.Min(_scans + 1, 1000);
        double share = Math.Max(Share, 1.0 / _scans);
        Density = Math.Max(_least, Density + (share * ((Math.Max(0, points) / squareMetres) - Density)));
    }
}
