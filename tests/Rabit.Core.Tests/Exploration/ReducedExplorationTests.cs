using System.Collections.Generic;
using System.Linq;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// What the explorer leaves out makes no difference: small scenarios are explored with it and without, with the same
/// verdict.
/// </summary>
public sealed class ReducedExplorationTests(ITestOutputHelper output)
{
    private static readonly ExplorerOptions Reduced = new(MemoryModel.StoreBuffers);

    /// <summary>Two reductions that keep the number of interleavings.</summary>
    [Fact]
    public void Explore_WithoutFolding_FindsTheSameInterleavings()
    {
        var scenario = new WakeUpScenario(1, 2) { Ticks = 1 };
        ExplorerOptions plain = Reduced with { WatchedSteps = 0, MergesRetries = false };

        ExplorationResult unfolded = Explore("event", scenario, plain);
        ExplorationResult folded = Explore("event", scenario, plain with { WatchedSteps = 5 });

        Assert.Null(unfolded.Fault);
        Assert.Null(folded.Fault);
        Assert.Equal(unfolded.Interleavings, folded.Interleavings);
        Assert.True(folded.States < unfolded.States, "nothing was folded");
    }

    [Theory]
    [InlineData("event", 1, 1)]
    [InlineData("futex", 1, 1)]
    public void Explore_WatchingFewAnswers_FindsTheSameInterleavings(string engine, int wakers, int wakesEach)
        => AssertTheSameWithFewAnswers(engine, All(wakers, wakesEach));

    [Theory, Trait("Category", "Long")]
    [InlineData("event", 2, 2)]
    [InlineData("event", 3, 1)]
    [InlineData("futex", 2, 1)]
    public void Explore_WatchingFewAnswersOfMoreWakers_FindsTheSameInterleavings(
        string engine, int wakers, int wakesEach)
        => AssertTheSameWithFewAnswers(engine, All(wakers, wakesEach));

    /// <summary>Those that walk fewer.</summary>
    [Theory]
    [InlineData("event", 1, 1, false)]
    [InlineData("futex", 1, 1, false)]
    [InlineData("event", 1, 1, true)]
    public void Explore_WithAndWithoutReductions_FindsNoFaultInProduction(
        string engine, int wakers, int wakesEach, bool isWeak)
        => AssertNoFaultWithAndWithout(engine, wakers, wakesEach, isWeak);

    [Theory, Trait("Category", "Long")]
    [InlineData("event", 1, 2, false)]
    [InlineData("event", 2, 1, false)]
    [InlineData("futex", 1, 2, false)]
    [InlineData("event", 2, 1, true)]
    public void Explore_MoreWakersWithAndWithoutReductions_FindsNoFaultInProduction(
        string engine, int wakers, int wakesEach, bool isWeak)
        => AssertNoFaultWithAndWithout(engine, wakers, wakesEach, isWeak);

    [Theory]
    [InlineData(SeededFault.None)]
    [InlineData(SeededFault.FlagClearedAfterTheWork)]
    [InlineData(SeededFault.FlagClearedByAPlainWrite)]
    [InlineData(SeededFault.FlagSetAfterTheSignal)]
    [InlineData(SeededFault.WaitWithoutRecheck)]
    [InlineData(SeededFault.WakeDroppedDuringStartup)]
    [InlineData(SeededFault.UnfencedAlreadySetRead)]
    [InlineData(SeededFault.StopWithoutASignal)]
    [InlineData(SeededFault.WakesThatStack)]
    public void Explore_SeededFaultWithoutReductions_HasTheSameResult(SeededFault fault)
    {
        WakeUpScenario scenario = SeededFaultTests.ScenarioOf(fault);
        ExplorerOptions whole = Reduced with { TakesFreeSteps = false, MergesRetries = false };

        ExplorationResult reduced = Explorer.Explore(Faulty(scenario, fault), Reduced);
        ExplorationResult unreduced = Explorer.Explore(Faulty(scenario with { ReadsInSteps = true }, fault), whole);

        output.WriteLine($"{reduced}\n{unreduced}");
        Assert.Equal(fault == SeededFault.None, reduced.Fault is null);
        Assert.Equal(fault == SeededFault.None, unreduced.Fault is null);
    }

    /// <summary>A write is not free where another thread writes too, even if that comes to light late.</summary>
    [Fact]
    public void Explore_ASecondWriterThatComesLate_IsNotOverlooked()
    {
        var outcomes = new HashSet<int>();
        int[] x = new int[1];
        var model = new SmallModel(
            1,
            state => outcomes.Add(state.Note(0)),
            () => default(ExploredSyncPoints).Write(ref x[0], 1),
            () =>
            {
                int before = default(ExploredSyncPoints).VolatileRead(ref x[0]);
                default(ExploredSyncPoints).Fence();
                default(ExploredSyncPoints).Exchange(ref x[0], 2);
                int after = default(ExploredSyncPoints).VolatileRead(ref x[0]);
                ExploredSyncPoints.Note((before, after), state => state.Note(0) = (10 * before) + after);
            });

        ExplorationResult result = Explorer.Explore(model, Reduced);

        // Written before the first read, before the exchange, between it and the last read, and seen or not.
        Assert.Null(result.Fault);
        Assert.Equal([1, 2, 12], outcomes.OrderBy(outcome => outcome));
    }

    private static WakeUpScenario All(int wakers, int wakesEach)
        => new(wakers, wakesEach) { Starts = true, Stops = true, Ticks = 1 };

    private static WakeUpModel Faulty(WakeUpScenario scenario, SeededFault fault)
        => new(scenario, clock => new FaultyWakeUp(fault, clock));

    private void AssertNoFaultWithAndWithout(string engine, int wakers, int wakesEach, bool isWeak)
    {
        WakeUpScenario scenario = All(wakers, wakesEach);
        ExplorerOptions options = isWeak ? Reduced with { Memory = MemoryModel.Weak } : Reduced;

        ExplorationResult reduced = Explore(engine, scenario, options);
        ExplorationResult withoutFreeSteps = Explore(engine, scenario, options with { TakesFreeSteps = false });
        ExplorationResult withReads = Explore(engine, scenario with { ReadsInSteps = true }, options);

        Assert.All([reduced, withoutFreeSteps, withReads], result => Assert.Null(result.Fault));
        Assert.True(reduced.States < withoutFreeSteps.States, "no step was free");
        Assert.True(reduced.States < withReads.States, "the reads were no steps");
    }
    private void AssertTheSameWithFewAnswers(string engine, WakeUpScenario scenario)
    {
        ExplorationResult all = Explore(engine, scenario, Reduced);
        ExplorationResult few = Explore(engine, scenario, Reduced with { WatchedAnswers = 2 });

        Assert.Null(all.Fault);
        Assert.Equal((all.Interleavings, all.States), (few.Interleavings, few.States));
    }

    private ExplorationResult Explore(string engine, WakeUpScenario scenario, ExplorerOptions options)
    {
        ExplorationResult result = Explorer.Explore(new WakeUpModel(scenario, ProductionWakeUp.On(engine)), options);
        output.WriteLine($"{engine}, {options}: {scenario}");
        output.WriteLine(result.ToString());
        return result;
    }
}
