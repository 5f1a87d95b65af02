using System;
using Rabit.Core.Time;
using Xunit;

namespace Rabit.Core.Tests.Time;

public sealed class RunClockTests
{
    [Theory, Trait("Clause", "5.1")]
    [InlineData(TimeSpan.TicksPerSecond)]
    [InlineData(1_000_000_000L)]
    [InlineData(1_000_000L)]
    [InlineData(1_000L)]
    [InlineData(24_000_000L)]
    public void Now_AnyFrequency_IsExactToATickAndMonotonic(long frequency)
    {
        var provider = new ManualClock(frequency) { Timestamp = 987_654_321 };
        var clock = new RunClock(provider);
        Assert.Equal(TimeSpan.Zero, clock.Now);

        long origin = provider.Timestamp;
        long last = 0;
        for (int second = 0; second < 100_000; second += 7)
        {
            long count = second * frequency + second;
            provider.Timestamp = origin + count;
            decimal exact = (decimal)count * TimeSpan.TicksPerSecond / frequency;
            Assert.InRange(clock.Now.Ticks, (long)exact - 1, (long)exact + 1);
            Assert.True(clock.Now.Ticks >= last);
            last = clock.Now.Ticks;
        }
    }

    [Fact, Trait("Clause", "5.1")]
    public void Now_OwnTicks_AreExactForTenYears()
    {
        var provider = new ManualClock();
        var clock = new RunClock(provider);
        provider.Timestamp = TimeSpan.FromDays(3653).Ticks + 1;

        Assert.Equal(TimeSpan.FromDays(3653).Ticks + 1, clock.Now.Ticks);
    }
}
