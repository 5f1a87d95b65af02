using System;
using Rabit.Core.Statistics;
using Xunit;

namespace Rabit.Core.Tests.Statistics;

/// <summary>Contract 4.4: what a manager's status says of its times.</summary>
public sealed class ManagerStatisticsTests
{
    private static readonly TimeSpan Short = TimeSpan.FromMilliseconds(1);
    private static readonly TimeSpan Long = TimeSpan.FromSeconds(10);

    private readonly ManagerStatistics _statistics = new();
    private ManagerStatus _status;

    [Fact, Trait("Clause", "4.4")]
    public void CountRun_Percentiles_AreThereAtOnceAndThenNowAndThen()
    {
        Count(TimeSpan.Zero, Short);
        TimeSpan first = _status.UnitOfWorkTime.Percentile50;
        Count(Short, TimeSpan.FromMilliseconds(400));
        TimeSpan before = _status.UnitOfWorkTime.Percentile999;
        Count(TimeSpan.FromHours(1), Long);

        AssertNear(Short, first);
        AssertNear(Short, before);
        AssertNear(Long, _status.UnitOfWorkTime.Percentile999);
    }

    [Fact, Trait("Clause", "4.4"), Trait("Clause", "1.7")]
    public void Reset_AtARestart_ForgetsTimesAndKeepsFaults()
    {
        _status.Faults = 3;
        Count(TimeSpan.Zero, Long);

        _statistics.Reset(ref _status);
        Assert.Equal((0, 3), (_status.UnitOfWorkTime.Count, _status.Faults));
        Count(TimeSpan.Zero, Short);
        Count(TimeSpan.FromHours(1), TimeSpan.FromSeconds(1));

        AssertNear(Short, _status.UnitOfWorkTime.Percentile50);
        AssertNear(Short, _status.WakeLatency.Percentile50);
        AssertNear(Short, _status.PeriodError.Percentile50);
    }

    // A unit of work that lasts so long, and began so long after its wake and its deadline.
    private void Count(TimeSpan at, TimeSpan time)
        => _statistics.CountRun(ref _status, at + time, at + time + time, wokenAt: at, deadline: at);

    private static void AssertNear(TimeSpan expected, TimeSpan actual)
        => Assert.InRange(actual.TotalMilliseconds, expected.TotalMilliseconds, expected.TotalMilliseconds * 1.07);
}
