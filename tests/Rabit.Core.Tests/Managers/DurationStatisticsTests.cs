using System;
using Xunit;

namespace Rabit.Core.Tests.Managers;

/// <summary>The figures of durations as text: what a log or a table of a person shows, in any culture.</summary>
public sealed class DurationStatisticsTests
{
    [Fact, Trait("Clause", "4.4")]
    public void ToString_WithoutPercentiles_HasNumberAndRange()
    {
        DurationStatistics statistics = default(DurationStatistics).With(TimeSpan.FromMilliseconds(1)).With(TimeSpan.FromMilliseconds(4));

        Assert.Equal("2 times, min 1.000 mean 2.500 max 4.000 ms", statistics.ToString());
    }

    [Fact, Trait("Clause", "4.4")]
    public void With_NegativeDuration_CountsAsZero()
    {
        DurationStatistics statistics = default(DurationStatistics).With(TimeSpan.FromMilliseconds(-1));

        Assert.Equal((1L, TimeSpan.Zero, TimeSpan.Zero), (statistics.Count, statistics.Minimum, statistics.Maximum));
    }
}
