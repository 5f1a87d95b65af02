using System;
using System.Globalization;
using Rabit.Core.Statistics;
using Rabit.Core.Time;

namespace Rabit.Core;

/// <summary>
/// How long something took, over all its times: number, shortest, longest, sum, and, where they are kept, percentiles.
/// A plain value.
/// </summary>
public struct DurationStatistics
{
    /// <summary>How many durations were measured.</summary>
    public long Count { get; private set; }

    /// <summary>The shortest; zero when none was measured.</summary>
    public TimeSpan Min { get; private set; }

    /// <summary>The longest; zero when none was measured.</summary>
    public TimeSpan Max { get; private set; }

    /// <summary>The sum.</summary>
    public TimeSpan Total { get; private set; }

    /// <summary>The mean; zero when none was measured.</summary>
    public readonly TimeSpan Mean => Count == 0 ? TimeSpan.Zero : new TimeSpan(Total.Ticks / Count);

    /// <summary>
    /// What half of them did not exceed, at most 6.25 % too long. In a <see cref="ManagerStatus"/> up to a second old;
    /// zero where no percentiles are kept.
    /// </summary>
    public TimeSpan Percentile50 { get; private set; }

    /// <summary>What 99 % of them did not exceed; as <see cref="Percentile50"/>.</summary>
    public TimeSpan Percentile99 { get; private set; }

    /// <summary>What 99.9 % of them did not exceed; as <see cref="Percentile50"/>.</summary>
    public TimeSpan Percentile999 { get; private set; }

    /// <summary>The same with one duration more. The percentiles stay as they are.</summary>
    /// <param name="duration">A negative one counts as zero.</param>
    public readonly DurationStatistics With(TimeSpan duration)
    {
        DurationStatistics next = this;
        next.Add(duration);
        return next;
    }

    /// <inheritdoc/>
    public readonly override string ToString()
    {
        string text = string.Format(
            CultureInfo.InvariantCulture,
            "{0} times, min {1:0.000} mean {2:0.000} max {3:0.000} ms",
            Count,
            Min.TotalMilliseconds,
            Mean.TotalMilliseconds,
            Max.TotalMilliseconds);
        return Percentile999 == TimeSpan.Zero ? text : text + string.Format(
            CultureInfo.InvariantCulture,
            ", p50 {0:0.000} p99 {1:0.000} p99.9 {2:0.000} ms",
            Percentile50.TotalMilliseconds,
            Percentile99.TotalMilliseconds,
            Percentile999.TotalMilliseconds);
    }

    internal void Add(TimeSpan duration)
    {
        if (duration < TimeSpan.Zero)
            duration = TimeSpan.Zero;
        if (Count == 0 || duration < Min)
            Min = duration;
        if (duration > Max)
            Max = duration;
        Total = Times.Later(Total, duration);
        Count++;
    }

    /// <summary>Takes the percentiles of a histogram, none above the longest.</summary>
    internal void TakePercentiles(DurationHistogram histogram)
    {
        histogram.Percentiles(out TimeSpan half, out TimeSpan p99, out TimeSpan p999);
        Percentile50 = Times.Earlier(half, Max);
        Percentile99 = Times.Earlier(p99, Max);
        Percentile999 = Times.Earlier(p999, Max);
    }
}
