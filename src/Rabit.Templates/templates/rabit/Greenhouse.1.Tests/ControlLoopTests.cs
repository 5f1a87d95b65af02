using System;
using System.Collections.Generic;
using Rabit.Core;
using Xunit;

namespace Greenhouse._1.Tests;

/// <summary>Both managers together, for an hour of virtual time.</summary>
public sealed class ControlLoopTests
{
    [Fact]
    public void Temperature_InAnHourOfSun_StaysNearTheLimits()
    {
        var reactor = new RabitReactor(new VirtualTime(seed: 1)) { new Climate(), new Equipment(_ => { }) };
        MessageSubscriber<AirTemperature> air = reactor.Workspace.Subscribe<AirTemperature>(Names.Air);
        reactor.Start();
        reactor.RunFor(TimeSpan.FromSeconds(10));   // from the cold

        for (int second = 10; second < 3600; second++)
        {
            Assert.True(reactor.RunFor(TimeSpan.FromSeconds(1)));
            air.Fetch();
            Assert.InRange(air.Value.Celsius, 22.5, 24.5);
        }

        reactor.Stop();
        Assert.Equal(0, reactor.Finish().ExitCode);
    }

    [Fact]
    public void Run_WithTheSameSeed_IsTheSame()
        => Assert.Equal(LinesOfAMinute(seed: 7), LinesOfAMinute(seed: 7));

    private static List<string> LinesOfAMinute(long seed)
    {
        var lines = new List<string>();
        var reactor = new RabitReactor(new VirtualTime(seed)) { new Climate(), new Equipment(lines.Add) };
        reactor.Start();
        reactor.RunFor(TimeSpan.FromMinutes(1));
        reactor.Stop();
        reactor.Finish();
        Assert.NotEmpty(lines);
        return lines;
    }
}
