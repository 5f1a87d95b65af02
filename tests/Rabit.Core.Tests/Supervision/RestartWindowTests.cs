using System;
using Rabit.Core.Supervision;
using Xunit;

namespace Rabit.Core.Tests.Supervision;

/// <summary>Contract 1.7: how many restarts a window takes, and the delays before them; times in seconds.</summary>
public sealed class RestartWindowTests
{
    private static readonly FaultPolicy Three = Policy(maxRestarts: 3);
    private readonly RestartWindow _window = new();

    [Fact]
    public void TryTake_AsManyAsAllowed_DoublesTheDelayAndThenRefuses()
    {
        Assert.Equal((true, 1), Take(Three, 0));
        Assert.Equal((true, 2), Take(Three, 10));
        Assert.Equal((true, 4), Take(Three, 20));
        Assert.False(Take(Three, 30).Taken);
    }

    [Fact]
    public void TryTake_OldOnesLeaveTheWindow_MakesRoomForAsMany()
    {
        foreach (int at in new[] { 0, 10, 20 })
            Take(Three, at);

        Assert.False(Take(Three, 59).Taken);
        Assert.Equal((true, 4), Take(Three, 60));
        Assert.False(Take(Three, 69).Taken);
        Assert.Equal((true, 4), Take(Three, 70));
        Assert.Equal((true, 4), Take(Three, 80));
        Assert.False(Take(Three, 119).Taken);
        Assert.Equal((true, 2), Take(Three, 135));
        Assert.Equal((true, 4), Take(Three, 139));
        Assert.Equal((true, 1), Take(Three, 1000));
    }

    [Fact]
    public void TryTake_PolicyWithAnotherNumber_BeginsAgain()
    {
        foreach (int at in new[] { 0, 10, 20 })
            Take(Three, at);

        Assert.Equal((true, 1), Take(Policy(maxRestarts: 1), 21));
        Assert.False(Take(Policy(maxRestarts: 1), 22).Taken);
    }

    [Theory]
    [InlineData(0, 1)]
    [InlineData(1, 2)]
    [InlineData(3, 8)]
    [InlineData(4, 10)]
    [InlineData(long.MaxValue, 10)]
    public void Delay_EachTime_DoublesUpToTheMax(long count, int seconds)
        => Assert.Equal(Seconds(seconds), BackOff.Delay(Seconds(1), Seconds(10), count));

    [Fact]
    public void Delay_MaxValue_DoesNotOverflow()
        => Assert.Equal(TimeSpan.MaxValue, BackOff.Delay(new TimeSpan((long.MaxValue / 2) + 1), TimeSpan.MaxValue, 1));

    private (bool Taken, int Delay) Take(FaultPolicy policy, int at)
    {
        bool taken = _window.TryTake(policy, Seconds(at), out TimeSpan delay);
        return (taken, (int)delay.TotalSeconds);
    }

    private static FaultPolicy Policy(int maxRestarts)
        => FaultPolicy.RestartAfter(Seconds(1), Seconds(8), maxRestarts, Seconds(60));

    private static TimeSpan Seconds(int seconds) => TimeSpan.FromSeconds(seconds);
}
