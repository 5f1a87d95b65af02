using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// The mean of bearings that are known up to a symmetry (axial data): angles are multiplied by how often the target
/// looks the same in a turn, averaged as unit vectors weighted by their variances, and divided again. Mardia and Jupp,
/// Directional Statistics, 1.3 and 9.1. A changing value: keep it in a field.
/// </summary>
internal struct BearingMean
{
    // Bearings without any sense would have a standard deviation of 0.29 periods; of what is not known better than
    // half of that, nothing is said.
    private const double MaxSigmaPeriods = 0.14;

    private Sums _full;
    private Sums _half;
    private Sums _quarter;

    /// <summary>The mean; null where there is none, or it is not known well enough.</summary>
    public readonly TargetBearing? Value
    {
        get
        {
            // Near the border between long and square both come; the more frequent one, of as many the cautious one.
            if (_quarter.Count > 0 && _quarter.Count >= Math.Max(_half.Count, _full.Count))
                return _quarter.Mean(BearingSymmetry.QuarterTurn);
            return _half.Count > 0 && _half.Count >= _full.Count
                ? _half.Mean(BearingSymmetry.HalfTurn)
                : _full.Mean(BearingSymmetry.None);
        }
    }

    /// <summary>Adds that of a report; null and what is no number says nothing.</summary>
    public void Add(in TargetBearing? reported)
    {
        if (reported is not { } bearing || !bearing.Angle.IsFinite || !bearing.TotalSigma.IsFinite
            || bearing.Sigma <= Angle.Zero)
            return;
        switch (bearing.Symmetry)
        {
            case BearingSymmetry.QuarterTurn:
                _quarter.Add(bearing);
                break;
            case BearingSymmetry.HalfTurn:
                _half.Add(bearing);
                break;
            default:
                _full.Add(bearing);
                break;
        }
    }

    /// <summary>Adds those of another track of the same target.</summary>
    public void Add(in BearingMean other)
    {
        _full.Add(other._full);
        _half.Add(other._half);
        _quarter.Add(other._quarter);
    }

    private struct Sums
    {
        private double _weights;
        private double _squares;   // of the weights
        private double _cos;
        private double _sin;
        private double _systematic;   // the largest, radians

        public int Count { get; private set; }

        public void Add(in TargetBearing bearing)
        {
            double weight = 1 / (bearing.Sigma.Radians * bearing.Sigma.Radians);
            double phase = 2 * Math.PI * (bearing.Angle / bearing.Period);
            Count++;
            _weights += weight;
            _squares += weight * weight;
            _cos += weight * Trig.Cos(phase);
            _sin += weight * Trig.Sin(phase);
            _systematic = Math.Max(_systematic, bearing.SystematicSigma.Radians);
        }

        public void Add(in Sums other)
        {
            Count += other.Count;
            _weights += other._weights;
            _squares += other._squares;
            _cos += other._cos;
            _sin += other._sin;
            _systematic = Math.Max(_systematic, other._systematic);
        }

        // How far the bearings differ counts where that is more than they state: of a wrapped normal distribution, the
        // variance of the phase is -2 ln R.
        public readonly TargetBearing? Mean(BearingSymmetry symmetry)
        {
            if (Count == 0)
                return null;
            double period = new TargetBearing(Angle.Zero, Angle.Zero, symmetry).Period.Radians;
            double resultant = Math.Min(1, Math.Sqrt((_cos * _cos) + (_sin * _sin)) / _weights);
            double spread = Math.Sqrt(Math.Max(0, -2 * Math.Log(resultant))) * period / (2 * Math.PI);
            double stated = Math.Sqrt(1 / _weights);
            double seen = spread * Math.Sqrt(_squares) / _weights;
            var mean = new TargetBearing(
                Angle.FromRadians(Math.Atan2(_sin, _cos) * period / (2 * Math.PI)),
                Angle.FromRadians(Math.Max(stated, seen)), symmetry)
            {
                SystematicSigma = Angle.FromRadians(_systematic),
            };
            return spread <= MaxSigmaPeriods * period && mean.TotalSigma.Radians <= MaxSigmaPeriods * period
                ? mean
                : null;
        }
    }
}
