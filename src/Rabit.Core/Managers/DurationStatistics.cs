using System;
using System.Globalization;

namespace Rabit.Core;

/// <summary>How long something took, over all its times: number, shortest, longest, sum. A plain value.</summary>
public readonly struct DurationStatistics
{
    private DurationStatistics(long count, TimeSpan minimum, TimeSpan maximum, TimeSpan total)
    {
        Count = count;
        Minimum = minimum;
        Maximum = maximum;
        Total = total;
    }

    /// <summary>How many durations were measured.</summary>
    public long Count { get; }

    /// <summary>The shortest; zero when none was measured.</summary>
    public TimeSpan Minimum { get; }

    /// <summary>The longest; zero when none was measured.</summary>
    public TimeSpan Maximum { get; }

    /// <summary>The sum.</summary>
    public TimeSpan Total { get; }

    /// <summary>The mean; zero when none was measured.</summary>
    public TimeSpan Mean => Count == 0 ? TimeSpan.Zero : new TimeSpan(Total.Ticks / Count);

    /// <summary>The same with one duration more.</summary>
    /// <param name="duration">A negative one counts as zero.</param>
    public DurationStatistics With(TimeSpan duration)
    {
        if (duration < TimeSpan.Zero)
            duration = TimeSpan.Zero;
        return new DurationStatistics(
            Count + 1,
            Count == 0 || duration < Minimum ? duration : Minimum,
            duration > Maximum ? duration : Maximum,
            Total + duration);
    }

    /// <inheritdoc/>
    public override string ToString() => string.Format(
        CultureInfo.InvariantCulture,
        "{0} times, min {1:0.000} mean {2:0.000} max {3:0.000} ms",
        Count,
        Minimum.TotalMilliseconds,
        Mean.TotalMilliseconds,
        Maximum.TotalMilliseconds);
}
