using System;

namespace Rabit.Uav.Reporting;

/// <summary>The smallest and the largest of the integers that came over the wire. A plain value.</summary>
/// <param name="minimum">The smallest.</param>
/// <param name="maximum">The largest.</param>
public readonly struct FlightRange(int minimum, int maximum)
{
    /// <summary>The smallest.</summary>
    public int Minimum { get; } = minimum;

    /// <summary>The largest.</summary>
    public int Maximum { get; } = maximum;

    /// <summary>The same with one value more.</summary>
    /// <param name="range">What there was; null before the first value.</param>
    /// <param name="value">The value.</param>
    internal static FlightRange Extend(FlightRange? range, int value) => range is { } known
        ? new FlightRange(Math.Min(known.Minimum, value), Math.Max(known.Maximum, value))
        : new FlightRange(value, value);
}
