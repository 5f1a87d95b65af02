using System;
using System.Globalization;
using Rabit.Core.Managers;

namespace Rabit.Core;

/// <summary>How long something took, over all its times: number, shortest, longest, sum, and, where they are kept, percentiles. A plain value.</summary>
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

    /// <summary>
    /// What half of them did not exceed, at most 6.25 % too long. In a <see cref="ManagerStatus"/> up to a second old; zero where no percentiles are kept.
    /// </summary>
    public TimeSpan Percentile50 { get; private init; }

    /// <summary>What 99 % of them did not exceed; as <see cref="Percentile50"/>.</summary>
    public TimeSpan Percentile99 { get; private init; }

    /// <summary>What 99.9 % of them did not exceed; as <see cref="Percentile50"/>.</summary>
    public TimeSpan Percentile999 { get; private init; }

    /// <summary>The same with one duration more. The percentiles stay as they are.</summary>
    /// <param name="duration">A negative one counts as zero.</param>
    public DurationStatistics With(TimeSpan duration)
    {
        if (duration < TimeSpan.Zero)
            duration = TimeSpan.Zero;
        return new DurationStatistics(
            Count + 1,
            Count == 0 || duration < Minimum ? duration : Minimum,
            duration > Maximum ? duration : Maximum,
            Times.Later(Total, duration))
        {
            Percentile50 = Percentile50,
            Percentile99 = Percentile99,
            Percentile999 = Percentile999,
        };
    }

    /// <inheritdoc/>
    public override string ToString()
    {
        string text = string.Format(
            CultureInfo.InvariantCulture,
            "{0} times, min {1:0.000} mean {2:0.000} max {3:0.000} ms",
            Count,
            Minimum.TotalMilliseconds,
            Mean.TotalMilliseconds,
            Maximum.TotalMilliseconds);
        return Percentile999 == TimeSpan.Zero ? text : text + string.Format(
            CultureInfo.InvariantCulture,
            ", p50 {0:0.000} p99 {1:0.000} p99.9 {2:0.000} ms",
            Percentile50.TotalMilliseconds,
            Percentile99.TotalMilliseconds,
            Percentile999.TotalMilliseconds);
    }

    /// <summary>The same with the percentiles of a histogram, none above the longest.</summary>
    internal DurationStatistics WithPercentilesOf(DurationHistogram histogram)
    {
        histogram.Percentiles(out TimeSpan half, out TimeSpan p99, out TimeSpan p999);
        return new DurationStatistics(Count, Minimum, Maximum, Total)
        {
            Percentile50 = half < Maximum ? half : Maximum,
            Percentile99 = p99 < Maximum ? p99 : Maximum,
            Percentile999 = p999 < Maximum ? p999 : Maximum,
        };
    }
}
