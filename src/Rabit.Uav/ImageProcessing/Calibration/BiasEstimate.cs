using System;
using System.Collections.Generic;

namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>
/// What a <see cref="BiasEstimator"/> found: biases that the flown geometry shows, those that it does not, and the
/// points. Immutable.
/// </summary>
public sealed class BiasEstimate
{
    private readonly double[] _values;
    private readonly double[,] _covariance;
    private readonly double[] _priors;
    private readonly IReadOnlyDictionary<int, BiasPoint> _points;

    internal BiasEstimate(
        double[] values, double[,] covariance, double[] priors, IReadOnlyDictionary<int, BiasPoint> points, BiasFit fit)
    {
        (_values, _covariance, _priors, _points, Fit) = (values, covariance, priors, points, fit);
        Unobserved = FindUnobserved();
    }

    /// <summary>How well the observations agree with it.</summary>
    public BiasFit Fit { get; }

    /// <summary>
    /// The combinations that the observations do not determine (unobservable), those of which least is known first.
    /// North and east of the vehicle are always among them.
    /// </summary>
    public IReadOnlyList<BiasCombination> Unobserved { get; }

    /// <summary>The points that were observed, by their numbers.</summary>
    public IReadOnlyDictionary<int, BiasPoint> Points => _points;

    /// <summary>A bias, if the observations determine it: if they at least halve its prior uncertainty.</summary>
    /// <param name="parameter">Which.</param>
    /// <param name="value">Radians, seconds or metres; not a number if the answer is false.</param>
    /// <param name="sigma">Its standard deviation; of what is not observed, that of the prior.</param>
    public bool TryGet(BiasParameter parameter, out double value, out double sigma)
    {
        sigma = Math.Sqrt(_covariance[(int)parameter, (int)parameter]);
        bool isObserved = _priors[(int)parameter] > 0 && sigma < 0.5 * _priors[(int)parameter];
        value = isObserved ? _values[(int)parameter] : double.NaN;
        return isObserved;
    }

    /// <summary>Covariance of two biases, in their units.</summary>
    /// <param name="a">One.</param>
    /// <param name="b">The other, or the same.</param>
    public double Covariance(BiasParameter a, BiasParameter b) => _covariance[(int)a, (int)b];

    /// <summary>
    /// The best value with the prior, also where the observations say nothing: a correction that does no harm, and no
    /// measurement.
    /// </summary>
    /// <param name="parameter">Which.</param>
    public double BestValue(BiasParameter parameter) => _values[(int)parameter];

    private List<BiasCombination> FindUnobserved()
    {
        var used = new List<int>();
        for (int i = 0; i < _priors.Length; i++)
        {
            if (_priors[i] > 0)
                used.Add(i);
        }

        var scaled = new double[used.Count, used.Count];
        for (int i = 0; i < used.Count; i++)
        {
            for (int j = 0; j < used.Count; j++)
                scaled[i, j] = _covariance[used[i], used[j]] / (_priors[used[i]] * _priors[used[j]]);
        }

        (double[] values, double[,] vectors) = SymmetricMatrix.Eigen(scaled);
        var found = new List<BiasCombination>();
        for (int k = 0; k < values.Length; k++)
        {
            if (values[k] < 0.25)
                continue;
            var weights = new Dictionary<BiasParameter, double>();
            for (int i = 0; i < used.Count; i++)
                weights[(BiasParameter)used[i]] = vectors[i, k];
            found.Add(new BiasCombination(weights, Math.Sqrt(values[k])));
        }

        found.Sort((a, b) => b.RemainingUncertainty.CompareTo(a.RemainingUncertainty));
        return found;
    }
}
