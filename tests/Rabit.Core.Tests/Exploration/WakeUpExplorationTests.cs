using System;
using Rabit.Core.Managers;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

public sealed class WakeUpExplorationTests(ITestOutputHelper output)
{
    [Theory]
    [InlineData(1, 1, 0, false, false, 0)]
    [InlineData(1, 2, 0, false, false, 0)]
    [InlineData(1, 2, 1, false, false, 0)]
    [InlineData(1, 2, 1, true, true, 1)]
    [InlineData(2, 1, 0, false, false, 0)]
    [InlineData(2, 1, 1, true, true, 1)]
    [InlineData(2, 2, 0, false, false, 0)]
    [InlineData(2, 2, 0, true, true, 0)]
    [InlineData(3, 1, 0, false, false, 0)]
    public void Try(int wakers, int wakes, int ticks, bool starts, bool stops, int early)
    {
        var scenario = new WakeUpScenario(wakers, wakes) { Ticks = ticks, Starts = starts, Stops = stops, EarlyReturns = early };
        foreach (Func<RunClock, WakeUpUnderTest> create in new Func<RunClock, WakeUpUnderTest>[] { ProductionWakeUp.OnEvent, ProductionWakeUp.OnFutex })
        {
            var watch = System.Diagnostics.Stopwatch.StartNew();
            ExplorationResult result = Explorer.Explore(new WakeUpModel(scenario, create));
            output.WriteLine($"{scenario} {create.Method.Name}: {result} {watch.Elapsed.TotalSeconds:F2} s");
            Assert.Null(result.Fault);
        }
    }
}
