using System;
using Rabit.Geodesy;

namespace Rabit.Uav.SensorFusion.Metrics;

/// <summary>
/// How far a set of estimated places is from the true ones, at one time: OSPA and GOSPA; and NEES, how honest a
/// covariance is. Distances are horizontal. For one thread; allocates only while its room grows.
/// </summary>
/// <example>
/// <code>
/// var metrics = new TrackingMetrics(cutoffMetres: 50, order: 1);
/// NedPosition[] truth = [new(0, 0, 0), new(100, 0, 0)];
/// NedPosition[] tracks = [new(3, 4, 0)];
/// Console.WriteLine(metrics.Ospa(truth, tracks));             // 27.5: one is 5 m off, one is missing
/// Console.WriteLine(metrics.Gospa(truth, tracks).Distance);   // 30: half the cutoff for the missing one
/// </code>
/// </example>
public sealed class TrackingMetrics
{
    private readonly double _cutoff;
    private readonly double _order;
    private readonly double _cutoffPower;
    private readonly Assignment _assignment = new();

    /// <summary>Makes metrics of one cutoff and order.</summary>
    /// <param name="cutoffMetres">From this distance on an estimate is not of a target; above 0.</param>
    /// <param name="order">The power p of the distances, 1 or more: a larger one weighs outliers more.</param>
    /// <exception cref="ArgumentOutOfRangeException">One of the two is out of its range.</exception>
    public TrackingMetrics(double cutoffMetres, double order)
    {
        if (!(cutoffMetres > 0 && cutoffMetres <= 1e6))
            throw new ArgumentOutOfRangeException(
                nameof(cutoffMetres), cutoffMetres, "The cutoff must be above 0 and at most 1e6 m.");
        if (!(order >= 1 && order <= 10))
            throw new ArgumentOutOfRangeException(nameof(order), order, "The order must be 1 to 10.");
        _cutoff = cutoffMetres;
        _order = order;
        _cutoffPower = Power(cutoffMetres);
    }

    /// <summary>
    /// Optimal sub-pattern assignment distance, metres: 0 for two equal sets, at most the cutoff (Schuhmacher, Vo, Vo:
    /// "A Consistent Metric for Performance Evaluation of Multi-Object Filters", 2008).
    /// </summary>
    /// <param name="truth">Where the targets are.</param>
    /// <param name="estimates">Where they are estimated to be, in any order.</param>
    public double Ospa(ReadOnlySpan<NedPosition> truth, ReadOnlySpan<NedPosition> estimates)
    {
        int larger = Math.Max(truth.Length, estimates.Length);
        if (larger == 0)
            return 0;
        Pair(truth, estimates, out int pairs, out double powers);
        return Root((powers + (_cutoffPower * (larger - pairs))) / larger);
    }

    /// <summary>
    /// Generalised OSPA distance, alpha 2: not divided by the number of targets, with its parts by places, missed and
    /// false ones (Rahmathullah, Garcia-Fernandez, Svensson: arXiv 1601.05585).
    /// </summary>
    /// <inheritdoc cref="Ospa"/>
    public GospaScore Gospa(ReadOnlySpan<NedPosition> truth, ReadOnlySpan<NedPosition> estimates)
    {
        Pair(truth, estimates, out int pairs, out double powers);
        double missed = _cutoffPower / 2 * (truth.Length - pairs);
        double wrong = _cutoffPower / 2 * (estimates.Length - pairs);
        return new GospaScore(Root(powers + missed + wrong), powers, missed, wrong);
    }

    /// <summary>
    /// Normalised squared error of an estimated position: over many runs its mean is 2 where the covariance is honest,
    /// and above that where it promises too much. Infinite for a covariance that is not positive definite.
    /// </summary>
    /// <param name="northErrorMetres">Estimate less truth, north.</param>
    /// <param name="eastErrorMetres">Estimate less truth, east.</param>
    /// <param name="covariance">What the estimate states.</param>
    public static double Nees(double northErrorMetres, double eastErrorMetres, HorizontalCovariance covariance)
        => covariance.MahalanobisSquared(northErrorMetres, eastErrorMetres);

    /// <summary>
    /// Normalised squared error of an estimated state of 1 to 16 numbers: over many runs its mean is that number where
    /// the covariance is honest. Infinite for a covariance that is not positive definite.
    /// </summary>
    /// <param name="error">Estimate less truth.</param>
    /// <param name="covariance">Upper triangle, row by row.</param>
    /// <exception cref="ArgumentException">The two do not fit together, or are too large.</exception>
    public static double Nees(ReadOnlySpan<double> error, ReadOnlySpan<double> covariance)
    {
        int n = error.Length;
        if (n is < 1 or > 16)
            throw new ArgumentException("The state must have 1 to 16 numbers.", nameof(error));
        if (covariance.Length != n * (n + 1) / 2)
            throw new ArgumentException(
                "The upper triangle of " + n + " numbers has " + (n * (n + 1) / 2) + ".", nameof(covariance));
        return SmallCholesky.MahalanobisSquared(error, covariance);
    }

    // A pair as far apart as the cutoff is none: both are then without a partner.
    private void Pair(
        ReadOnlySpan<NedPosition> truth, ReadOnlySpan<NedPosition> estimates, out int pairs, out double powers)
    {
        _assignment.Begin(truth.Length, estimates.Length, _cutoffPower);
        for (int t = 0; t < truth.Length; t++)
        {
            for (int e = 0; e < estimates.Length; e++)
            {
                double distance = truth[t].HorizontalDistanceTo(estimates[e]);
                if (distance < _cutoff)
                    _assignment.Allow(t, e, Power(distance));
            }
        }

        _assignment.Solve();
        (pairs, powers) = (0, 0);
        for (int t = 0; t < truth.Length; t++)
        {
            int e = _assignment.ColumnOf(t);
            if (e < 0)
                continue;
            pairs++;
            powers += Power(truth[t].HorizontalDistanceTo(estimates[e]));
        }
    }

    private double Power(double value)
    {
        if (_order == 1)
            return value;
        return _order == 2 ? value * value : Math.Pow(value, _order);
    }

    private double Root(double value)
    {
        if (_order == 1)
            return value;
        return _order == 2 ? Math.Sqrt(value) : Math.Pow(value, 1 / _order);
    }
}
