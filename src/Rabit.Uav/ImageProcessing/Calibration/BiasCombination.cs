using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>A combination of biases that the looks do not tell: along it nothing is known but what was known before. Immutable.</summary>
public sealed class BiasCombination
{
    private const double Least = 0.2;

    internal BiasCombination(IReadOnlyDictionary<BiasParameter, double> weights, double remaining)
    {
        Weights = weights;
        RemainingUncertainty = remaining;
    }

    /// <summary>The share of each bias, in standard deviations of what was known before; their squares sum to 1.</summary>
    public IReadOnlyDictionary<BiasParameter, double> Weights { get; }

    /// <summary>How much of the uncertainty from before is left along it, 0 to 1.</summary>
    public double RemainingUncertainty { get; }

    /// <summary>As "0.71 MountPitch + 0.68 AttitudePitch (96 % left)".</summary>
    public override string ToString()
    {
        IEnumerable<string> parts = Weights.Where(w => Math.Abs(w.Value) >= Least)
            .OrderByDescending(w => Math.Abs(w.Value))
            .Select((w, i) => FormattableString.Invariant($"{(w.Value < 0 ? "- " : i > 0 ? "+ " : "")}{Math.Abs(w.Value):0.00} {w.Key}"));
        return string.Join(" ", parts) + FormattableString.Invariant($" ({100 * RemainingUncertainty:0} % left)");
    }
}
