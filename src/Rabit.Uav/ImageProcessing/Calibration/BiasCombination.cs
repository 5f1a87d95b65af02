using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>
/// A combination of biases that the observations do not determine: along it nothing is known but the prior. Immutable.
/// </summary>
public sealed class BiasCombination
{
    private const double MinShownWeight = 0.2;

    internal BiasCombination(IReadOnlyDictionary<BiasParameter, double> weights, double remaining)
    {
        Weights = weights;
        RemainingUncertainty = remaining;
    }

    /// <summary>The share of each bias, in standard deviations of the prior; their squares sum to 1.</summary>
    public IReadOnlyDictionary<BiasParameter, double> Weights { get; }

    /// <summary>How much of the prior uncertainty is left along it, 0 to 1.</summary>
    public double RemainingUncertainty { get; }

    /// <summary>As "0.71 MountPitch + 0.68 AttitudePitch (96 % left)".</summary>
    public override string ToString()
    {
        IEnumerable<string> parts = Weights.Where(w => Math.Abs(w.Value) >= MinShownWeight)
            .OrderByDescending(w => Math.Abs(w.Value))
            .Select(
                (w, i) => FormattableString.Invariant(
                    $"{(w.Value < 0 ? "- " : i > 0 ? "+ " : "")}{Math.Abs(w.Value):0.00} {w.Key}"));
        return string.Join(" ", parts) + FormattableString.Invariant($" ({100 * RemainingUncertainty:0} % left)");
    }
}
