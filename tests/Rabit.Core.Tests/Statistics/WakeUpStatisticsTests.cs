using Xunit;

namespace Rabit.Core.Tests.Statistics;

/// <summary>Contract 4.4: each cause has a counter of its own.</summary>
public sealed class WakeUpStatisticsTests
{
    [Theory]
    [InlineData(WakeUpCauses.Start, 0, 0, 0, 0, 0, 0)]
    [InlineData(WakeUpCauses.Timer, 1, 0, 0, 0, 0, 0)]
    [InlineData(WakeUpCauses.Post, 0, 1, 0, 0, 0, 0)]
    [InlineData(WakeUpCauses.Push, 0, 0, 1, 0, 0, 0)]
    [InlineData(WakeUpCauses.Pop, 0, 0, 0, 1, 0, 0)]
    [InlineData(WakeUpCauses.Request, 0, 0, 0, 0, 1, 0)]
    [InlineData(WakeUpCauses.Device, 0, 0, 0, 0, 0, 1)]
    [InlineData(WakeUpCauses.Timer | WakeUpCauses.Device, 1, 0, 0, 0, 0, 1)]
    public void Count_Causes_CountsEachOfThemAndNoOther(
        WakeUpCauses causes, int timer, int post, int push, int pop, int request, int device)
    {
        var counts = default(WakeUpStatistics);

        counts.Count(causes, wakes: 1);

        Assert.Equal(
            (timer, post, push, pop, request, device),
            (counts.Timer, counts.Post, counts.Push, counts.Pop, counts.Request, counts.Device));
        Assert.Equal(0, counts.Merged);
    }

    [Fact]
    public void Count_SeveralWakesAtOnce_CountsThoseThatMerged()
    {
        var counts = default(WakeUpStatistics);

        counts.Count(WakeUpCauses.Timer, wakes: 0);
        counts.Count(WakeUpCauses.Post, wakes: 3);
        counts.Count(WakeUpCauses.Post, wakes: 2);

        Assert.Equal((2L, 3L), (counts.Post, counts.Merged));
    }
}
