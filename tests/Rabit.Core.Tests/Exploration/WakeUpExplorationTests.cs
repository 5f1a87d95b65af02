using System;
using System.Collections.Generic;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Contract 1.2, 1.4 and 1.6 in every interleaving of the code that flies, on both wait engines: no wake lost, none in
/// two turns, exactly one more turn for any number of them, and a stop gets through. The numbers of interleavings are
/// printed.
/// </summary>
public sealed class WakeUpExplorationTests(ITestOutputHelper output)
{
    // Many values of one word: to watch all of them for all steps takes longer than the exploration
    // (ReducedExplorationTests).
    private const int WatchedAnswers = 2;

    [Theory, Trait("Clause", "1.2"), Trait("Clause", "1.4"), Trait("Clause", "1.6")]
    [InlineData("event", 2, 2)]
    [InlineData("futex", 2, 2)]
    [InlineData("event", 3, 2)]
    [InlineData("futex", 3, 1)]
    public void Wakes_OfASleeperWithoutATimer_AreNeitherLostNorStacked(string engine, int wakers, int wakesEach)
        => AssertNoFault(engine, new WakeUpScenario(wakers, wakesEach), MemoryModel.StoreBuffers);

    [Theory, Trait("Clause", "1.2"), Trait("Clause", "1.4"), Trait("Clause", "1.6")]
    [InlineData("event", 1, 2)]
    [InlineData("event", 2, 1)]
    [InlineData("futex", 1, 1)]
    [InlineData("futex", 1, 2)]
    public void Wakes_FromTheBarrierToTheStopWithATimer_AreNeitherLostNorStacked(
        string engine, int wakers, int wakesEach)
        => AssertNoFault(engine, All(wakers, wakesEach) with { EarlyReturns = 1 }, MemoryModel.StoreBuffers);

    [Theory, Trait("Clause", "1.4"), Trait("Clause", "1.6")]
    [InlineData("event", 1, 2)]
    [InlineData("event", 2, 1)]
    [InlineData("futex", 1, 1)]
    public void Wakes_OnAMemoryThatAlsoReadsEarly_AreNeitherLostNorStacked(string engine, int wakers, int wakesEach)
        => AssertNoFault(
            engine, new WakeUpScenario(wakers, wakesEach) { Stops = true, Starts = true }, MemoryModel.Weak);

    [Theory, Trait("Clause", "1.4"), Trait("Clause", "1.7")]
    [InlineData("event")]
    [InlineData("futex")]
    public void Wakes_DuringABackOff_WaitForItsEnd(string engine)
        => AssertNoFault(
            engine, new WakeUpScenario(1, 2) { Ticks = 2, BacksOff = true, EarlyReturns = 1 },
            MemoryModel.StoreBuffers);

    [Theory, Trait("Clause", "1.6")]
    [InlineData("event")]
    [InlineData("futex")]
    public void Stop_BeforeTheBarrierOpens_GetsThrough(string engine)
        => AssertNoFault(engine, new WakeUpScenario(2, 1) { Stops = true }, MemoryModel.StoreBuffers);

    [Fact, Trait("Category", "Long"), Trait("Clause", "1.4")]
    public void Wakes_OfThreeWakersTwiceEachOnAFutex_AreNeitherLostNorStacked()
        => AssertNoFault("futex", new WakeUpScenario(3, 2), MemoryModel.StoreBuffers);

    [Theory, Trait("Category", "Long"), Trait("Clause", "1.2"), Trait("Clause", "1.4"), Trait("Clause", "1.6")]
    [InlineData("event", 3, 2, 0)]
    [InlineData("event", 3, 2, 1)]
    [InlineData("event", 2, 2, 1)]
    [InlineData("futex", 3, 2, 0)]
    [InlineData("futex", 2, 2, 1)]
    public void Wakes_FromTheBarrierToTheStop_OfMoreWakers_AreNeitherLostNorStacked(
        string engine, int wakers, int wakesEach, int earlyReturns)
        => AssertNoFault(engine, All(wakers, wakesEach) with { EarlyReturns = earlyReturns }, MemoryModel.StoreBuffers);

    [Theory, Trait("Category", "Long"), Trait("Clause", "1.4"), Trait("Clause", "1.6")]
    [InlineData("event", 3, 1)]
    [InlineData("event", 2, 2)]
    public void Wakes_OfMoreWakersOnAMemoryThatAlsoReadsEarly_AreNeitherLostNorStacked(
        string engine, int wakers, int wakesEach)
        => AssertNoFault(
            engine, new WakeUpScenario(wakers, wakesEach) { Stops = true, Starts = true }, MemoryModel.Weak);

    private static WakeUpScenario All(int wakers, int wakesEach)
        => new(wakers, wakesEach) { Starts = true, Stops = true, Ticks = 1 };

    private void AssertNoFault(string engine, WakeUpScenario scenario, MemoryModel memory)
    {
        ExplorationResult result = Explorer.Explore(
            new WakeUpModel(scenario, ProductionWakeUp.On(engine)),
            new ExplorerOptions(memory) { WatchedAnswers = WatchedAnswers });
        output.WriteLine($"{engine}, {memory}: {scenario}");
        output.WriteLine(result.ToString());
        Assert.True(result.Fault is null, result.ToString());
    }
}
