using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Latency.Measuring;

/// <summary>One quantity of one subject: a value from each round.</summary>
internal sealed class Series
{
    private readonly List<double> _values = [];

    public IReadOnlyList<double> Values => _values;

    public double Median => MedianOf(_values);

    public void Add(double value) => _values.Add(value);

    /// <summary>The median of the ratios round by round: what slowed a whole round down falls out.</summary>
    public double RatioTo(Series other) => MedianOf(_values.Zip(other._values, (own, limit) => own / limit));

    private static double MedianOf(IEnumerable<double> values)
    {
        double[] sorted = [.. values.OrderBy(v => v)];
        if (sorted.Length == 0)
            throw new InvalidOperationException("Nothing was measured.");
        return (sorted[(sorted.Length - 1) / 2] + sorted[sorted.Length / 2]) / 2;
    }
}
