using System;
using Rabit.Core.Statistics;
using Xunit;

namespace Rabit.Core.Tests.Statistics;

/// <summary>The figures of durations as text: what a log or a table of a person shows, in any culture.</summary>
public sealed class DurationStatisticsTests
{
    [Fact, Trait("Clause", "4.4")]
    public void ToString_WithoutPercentiles_HasNumberAndRange()
    {
        DurationStatistics statistics = default(DurationStatistics).With(TimeSpan.FromMilliseconds(1))
            .With(TimeSpan.FromMilliseconds(4));

        Assert.Equal("2 times, min 1.000 mean 2.500 max 4.000 ms", statistics.ToString());
    }

    [Fact, Trait("Clause", "4.4")]
    public void ToString_WithPercentiles_HasThemToo()
    {
        DurationStatistics statistics = default(DurationStatistics).With(TimeSpan.FromMilliseconds(1))
            .With(TimeSpan.FromMilliseconds(4));
        var histogram = new DurationHistogram();
        histogram.Add(TimeSpan.FromMilliseconds(1));
        histogram.Add(TimeSpan.FromMilliseconds(4));

        statistics.TakePercentiles(histogram);

        // Half of them: the upper end of its step of the histogram; the others are capped by the longest.
        Assert.Equal(
            FormattableString.Invariant(
                $"2 times, min 1.000 mean 2.500 max 4.000 ms, p50 {statistics.Percentile50.TotalMilliseconds:0.000} p99 4.000 p99.9 4.000 ms"),
            statistics.ToString());
        Assert.InRange(statistics.Percentile50, TimeSpan.FromMilliseconds(1), TimeSpan.FromTicks(10_625));
    }

    [Fact, Trait("Clause", "4.4")]
    public void With_NegativeDuration_CountsAsZero()
    {
        DurationStatistics statistics = default(DurationStatistics).With(TimeSpan.FromMilliseconds(-1));

        Assert.Equal((1L, TimeSpan.Zero, TimeSpan.Zero), (statistics.Count, statistics.Min, statistics.Max));
    }
}
