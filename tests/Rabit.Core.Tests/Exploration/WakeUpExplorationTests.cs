using System;
using System.Collections.Generic;
using Rabit.Core.Managers;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Contract 1.2, 1.4 and 1.6 in every interleaving of the code that flies, on both wait engines: no wake lost, none in two turns, exactly one
/// more turn for any number of them, and a stop gets through. The numbers of interleavings are printed.
/// </summary>
public sealed class WakeUpExplorationTests(ITestOutputHelper output)
{
    private static readonly Dictionary<string, Func<RunClock, WakeUpUnderTest>> Engines = new(StringComparer.Ordinal)
    {
        ["event"] = ProductionWakeUp.OnEvent,
        ["futex"] = ProductionWakeUp.OnFutex,
    };

    [Theory, Trait("Clause", "1.2"), Trait("Clause", "1.4"), Trait("Clause", "1.6")]
    [InlineData("event", 2, 2)]
    [InlineData("futex", 2, 2)]
    [InlineData("event", 3, 2)]
    [InlineData("futex", 3, 1)]
    public void Wakes_OfASleeperWithoutATimer_AreNeitherLostNorStacked(string engine, int wakers, int wakesEach)
        => AssertNoFault(engine, new WakeUpScenario(wakers, wakesEach), MemoryModel.StoreBuffers);

    [Theory, Trait("Clause", "1.2"), Trait("Clause", "1.4"), Trait("Clause", "1.6")]
    [InlineData("event", 1, 2)]
    [InlineData("futex", 1, 1)]
    public void Wakes_FromTheBarrierToTheStopWithATimer_AreNeitherLostNorStacked(string engine, int wakers, int wakesEach)
        => AssertNoFault(
            engine, new WakeUpScenario(wakers, wakesEach) { Starts = true, Stops = true, Ticks = 1, EarlyReturns = 1 }, MemoryModel.StoreBuffers);

    [Theory, Trait("Clause", "1.4"), Trait("Clause", "1.6")]
    [InlineData("event", 1, 2)]
    [InlineData("futex", 1, 1)]
    public void Wakes_OnAMemoryThatAlsoReadsEarly_AreNeitherLostNorStacked(string engine, int wakers, int wakesEach)
        => AssertNoFault(engine, new WakeUpScenario(wakers, wakesEach) { Stops = true, Starts = true }, MemoryModel.Weak);

    [Theory, Trait("Clause", "1.4"), Trait("Clause", "1.7")]
    [InlineData("event")]
    [InlineData("futex")]
    public void Wakes_DuringABackOff_WaitForItsEnd(string engine)
        => AssertNoFault(engine, new WakeUpScenario(1, 2) { Ticks = 2, BacksOff = true, EarlyReturns = 1 }, MemoryModel.StoreBuffers);

    [Theory, Trait("Clause", "1.6")]
    [InlineData("event")]
    [InlineData("futex")]
    public void Stop_BeforeTheBarrierOpens_GetsThrough(string engine)
        => AssertNoFault(engine, new WakeUpScenario(2, 1) { Stops = true }, MemoryModel.StoreBuffers);

    /// <summary>What the explorer does not walk twice makes no difference: the same number of interleavings, and no fault in those it merges.</summary>
    [Fact]
    public void Explore_WithoutFoldingAndMerging_FindsTheSame()
    {
        var scenario = new WakeUpScenario(1, 2) { Ticks = 1 };
        var plain = new ExplorerOptions(MemoryModel.StoreBuffers) { WatchedSteps = 0, MergesRetries = false };

        ExplorationResult unfolded = Explore("event", scenario, plain);
        ExplorationResult folded = Explore("event", scenario, plain with { WatchedSteps = 5 });

        Assert.Null(unfolded.Fault);
        Assert.Null(folded.Fault);
        Assert.Equal(unfolded.Interleavings, folded.Interleavings);
        Assert.True(folded.States < unfolded.States, "nothing was folded");
    }

    [Fact, Trait("Category", "Long"), Trait("Clause", "1.4")]
    public void Wakes_OfThreeWakersTwiceEachOnAFutex_AreNeitherLostNorStacked()
        => AssertNoFault("futex", new WakeUpScenario(3, 2), MemoryModel.StoreBuffers);

    [Theory, Trait("Category", "Long"), Trait("Clause", "1.2"), Trait("Clause", "1.4"), Trait("Clause", "1.6")]
    [InlineData("event", 3, 1, 0)]
    [InlineData("event", 2, 2, 1)]
    [InlineData("futex", 2, 1, 0)]
    public void Wakes_FromTheBarrierToTheStop_OfMoreWakers_AreNeitherLostNorStacked(string engine, int wakers, int wakesEach, int earlyReturns)
        => AssertNoFault(
            engine,
            new WakeUpScenario(wakers, wakesEach) { Stops = true, Starts = true, Ticks = 1, EarlyReturns = earlyReturns },
            MemoryModel.StoreBuffers);

    private void AssertNoFault(string engine, WakeUpScenario scenario, MemoryModel memory)
    {
        ExplorationResult result = Explore(engine, scenario, new ExplorerOptions(memory));
        Assert.True(result.Fault is null, result.ToString());
    }

    private ExplorationResult Explore(string engine, WakeUpScenario scenario, ExplorerOptions options)
    {
        ExplorationResult result = Explorer.Explore(new WakeUpModel(scenario, Engines[engine]), options);
        output.WriteLine($"{engine}, {options.Memory}: {scenario}");
        output.WriteLine(result.ToString());
        return result;
    }
}
