using System;
using Rabit.Uav.Communications;
using Xunit;

namespace Rabit.Uav.Tests.Communications.Exchange;

/// <summary>A link carries each datagram sooner or later, and says when.</summary>
public sealed class TunnelRateLimiterTests
{
    private const int Datagram = 145;

    [Fact]
    public void HasRoom_RateBelowADatagramASecond_HasItEachTimeThatTheRateAllowsIt()
    {
        var limiter = new TunnelRateLimiter(100, Datagram);
        Assert.True(limiter.HasRoom(Datagram, TimeSpan.Zero));
        limiter.Take(Datagram);
        Assert.False(limiter.HasRoom(Datagram, TimeSpan.FromSeconds(1.4)));
        Assert.True(limiter.HasRoom(Datagram, TimeSpan.FromSeconds(1.5)));
        limiter.Take(Datagram);
        Assert.False(limiter.HasRoom(Datagram, TimeSpan.FromSeconds(2.9)));
        Assert.True(limiter.HasRoom(Datagram, TimeSpan.FromSeconds(60)));
        limiter.Take(Datagram);
        Assert.False(limiter.HasRoom(Datagram, TimeSpan.FromSeconds(60.1)));
    }

    [Fact]
    public void TimeToRoom_SaysWhenThereIs()
    {
        var limiter = new TunnelRateLimiter(100, Datagram);
        Assert.Equal(TimeSpan.Zero, limiter.TimeToRoom(Datagram, TimeSpan.Zero));
        limiter.Take(Datagram);
        TimeSpan wait = limiter.TimeToRoom(Datagram, TimeSpan.FromSeconds(0.45));
        Assert.Equal(1, wait.TotalSeconds, 3);
        Assert.True(limiter.HasRoom(Datagram, TimeSpan.FromSeconds(0.45) + wait));
    }
}
