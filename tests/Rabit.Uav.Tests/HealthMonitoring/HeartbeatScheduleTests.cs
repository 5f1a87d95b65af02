using System;
using Rabit.Uav.HealthMonitoring;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

public class HeartbeatScheduleTests
{
    private readonly HeartbeatSchedule _schedule = new(TimeSpan.FromSeconds(1), TimeSpan.FromMilliseconds(250));

    [Theory]
    [InlineData(10.0, 0.25)]
    [InlineData(10.1, 0.15)]
    [InlineData(10.249, 0.001)]
    [InlineData(10.25, 0.25)]
    [InlineData(17.3, 0.2)]
    public void UntilNext_AnyTime_LeadsBackToTheGrid(double now, double expected)
    {
        _schedule.TakeBeat(TimeSpan.FromSeconds(10));
        Assert.Equal(TimeSpan.FromSeconds(expected), _schedule.UntilNext(TimeSpan.FromSeconds(now)));
    }

    [Fact]
    public void TakeBeat_LateOnes_AreNotMadeUpFor()
    {
        Assert.True(Take(10));
        Assert.False(Take(10.999));
        Assert.True(Take(11));
        Assert.False(Take(11));
        Assert.True(Take(14.7));
        Assert.False(Take(14.9));
        Assert.True(Take(15));
    }

    private bool Take(double seconds) => _schedule.TakeBeat(TimeSpan.FromSeconds(seconds));
}
