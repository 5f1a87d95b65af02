using System.Linq;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Contract 1.8 and 2.2 to 2.4 in every interleaving of the slots that keep the posts of a message: what is fetched was
/// posted, whole, with its version; versions are in order; who posts or fetches waits for no one. A slot is written
/// again in the third post of a poster at the earliest.
/// </summary>
public sealed class SlotExplorationTests(ITestOutputHelper output)
{
    private const int WatchedSteps = 12;

    /// <summary>Memory, posts of each poster, fetchers, fetches of each, tries before a fetch pins.</summary>
    public static TheoryData<string, string, int, int, int> Small() => new()
    {
        { "Weak", "3", 1, 1, 0 },
        { "Weak", "3", 1, 1, 1 },
        { "Weak", "4", 1, 2, 1 },
        { "Weak", "5", 1, 1, 1 },   // fewer posts do not need the fences that a fetcher demands
        { "StoreBuffers", "4", 1, 2, 2 },
        { "StoreBuffers", "4", 2, 1, 1 },
        { "Weak", "1 1", 1, 1, 1 },
        { "Weak", "2 1", 1, 1, 0 },
        { "StoreBuffers", "2 1", 1, 2, 0 },
        { "StoreBuffers", "1", 2, 1, 0 },
    };

    /// <summary>As <see cref="Small"/>.</summary>
    public static TheoryData<string, string, int, int, int> Large() => new()
    {
        { "Weak", "3 1", 1, 1, 0 },
        { "StoreBuffers", "3 1", 1, 1, 1 },
        { "StoreBuffers", "2 2", 1, 2, 0 },
        { "Weak", "5", 1, 2, 1 },
        { "StoreBuffers", "4", 2, 2, 1 },
        { "StoreBuffers", "3 2", 1, 1, 1 },
        { "StoreBuffers", "1 1 1", 1, 1, 1 },
    };

    [Theory, Trait("Clause", "1.8"), Trait("Clause", "2.2"), Trait("Clause", "2.3"), Trait("Clause", "2.4")]
    [MemberData(nameof(Small))]
    public void Fetch_InEveryInterleaving_IsWholeAndInOrder(
        string memory, string posts, int fetchers, int fetches, int tries)
        => AssertNoFault(memory, posts, fetchers, fetches, tries);

    [Theory, Trait("Category", "Long")]
    [MemberData(nameof(Large))]
    public void Fetch_InEveryInterleavingOfMore_IsWholeAndInOrder(
        string memory, string posts, int fetchers, int fetches, int tries)
        => AssertNoFault(memory, posts, fetchers, fetches, tries);

    /// <summary>That the exploration finds what it is for.</summary>
    [Theory]
    [InlineData(SeededSlotFault.PinWithoutARecheck)]
    [InlineData(SeededSlotFault.RecheckBeforeThePin)]
    [InlineData(SeededSlotFault.UnpinBeforeTheCopy)]
    [InlineData(SeededSlotFault.SpareTakenThoughPinned)]
    [InlineData(SeededSlotFault.VersionAfterTheValue)]
    [InlineData(SeededSlotFault.NoStoreBarrier)]
    [InlineData(SeededSlotFault.NoLoadBarrier)]
    [InlineData(SeededSlotFault.NoSwap)]
    [InlineData(SeededSlotFault.DemandIgnored)]
    [InlineData(SeededSlotFault.DemandWithoutAFence)]
    public void Exploration_OfATwinWithAFault_FindsIt(SeededSlotFault fault)
    {
        SlotScenario scenario = ScenarioFor(fault);

        ExplorationResult wrong = Explore(MemoryModel.Weak, scenario, new FaultySlots(scenario, fault));

        output.WriteLine(wrong.ToString());
        Assert.NotNull(wrong.Fault);
    }

    /// <summary>
    /// That a fetcher is not starved (contract 2.4) is found too: posts that come all the way around at each of its
    /// tries keep it for no more of them than it has, since it pins then.
    /// </summary>
    [Fact, Trait("Clause", "2.4")]
    public void Exploration_OfATwinThatNeverPins_FindsTheFetchThatTriesOn()
    {
        SlotScenario scenario = ScenarioFor(SeededSlotFault.NeverPins);

        ExplorationResult right = Explore(
            MemoryModel.StoreBuffers, scenario, new FaultySlots(scenario, SeededSlotFault.None));
        ExplorationResult wrong = Explore(
            MemoryModel.StoreBuffers, scenario, new FaultySlots(scenario, SeededSlotFault.NeverPins));

        output.WriteLine(wrong.ToString());
        Assert.True(right.Fault is null, right.ToString());
        Assert.Equal(SlotModel.TriesOn, wrong.Fault);
    }

    /// <summary>
    /// How often a fetch that pins looks for the latest slot is bounded by the posts that come in between, which all
    /// explorations here check. So one is found that waits for another fetcher to let go.
    /// </summary>
    [Fact, Trait("Clause", "2.4")]
    public void Exploration_OfATwinWhoseFetchersPinAlone_FindsTheFetchThatLooksOn()
    {
        var scenario = new SlotScenario([1], 2, 1, 0);

        ExplorationResult right = Explore(
            MemoryModel.StoreBuffers, scenario, new FaultySlots(scenario, SeededSlotFault.None));
        ExplorationResult wrong = Explore(
            MemoryModel.StoreBuffers, scenario, new FaultySlots(scenario, SeededSlotFault.PinsAlone));

        output.WriteLine(wrong.ToString());
        Assert.True(right.Fault is null, right.ToString());
        Assert.Equal(SlotModel.LooksOn, wrong.Fault);
    }

    /// <summary>The twin is right but for its fault.</summary>
    [Theory]
    [InlineData(SeededSlotFault.NoSwap)]
    [InlineData(SeededSlotFault.NoStoreBarrier)]
    [InlineData(SeededSlotFault.PinWithoutARecheck)]
    public void Exploration_OfTheTwinWithoutItsFault_FindsNone(SeededSlotFault fault)
    {
        SlotScenario scenario = ScenarioFor(fault);

        ExplorationResult right = Explore(
            MemoryModel.Weak, scenario, new FaultySlots(scenario, SeededSlotFault.None));

        Assert.True(right.Fault is null, right.ToString());
    }

    /// <summary>
    /// Where all spares may be pinned the pool grows, which the code that is explored cannot do again and again; its
    /// twin has the slot from the start.
    /// </summary>
    [Fact, Trait("Category", "Long")]
    public void Exploration_OfTheTwinWithAllSparesPinned_FindsNone()
    {
        var scenario = new SlotScenario([4], 2, 1, 1) { Spares = 2 };

        ExplorationResult right = Explore(
            MemoryModel.StoreBuffers, scenario, new FaultySlots(scenario, SeededSlotFault.None));

        Assert.True(right.Fault is null, right.ToString());
    }

    // Who must be there for the fault to show.
    private static SlotScenario ScenarioFor(SeededSlotFault fault) => fault switch
    {
        SeededSlotFault.NoSwap => new SlotScenario([1, 1], 1, 1, 1),
        SeededSlotFault.NeverPins or SeededSlotFault.VersionAfterTheValue or SeededSlotFault.NoStoreBarrier
            or SeededSlotFault.NoLoadBarrier or SeededSlotFault.DemandIgnored or SeededSlotFault.DemandWithoutAFence =>
                new SlotScenario([5], 1, 1, 1),
        _ => new SlotScenario([3], 1, 1, 0),
    };

    private void AssertNoFault(string memory, string posts, int fetchers, int fetches, int tries)
    {
        var scenario = new SlotScenario([.. posts.Split(' ').Select(int.Parse)], fetchers, fetches, tries);

        ExplorationResult result = Explore(
            MemoryModels.Named(memory), scenario,
            new ProductionSlots(scenario));

        output.WriteLine(result.ToString());
        Assert.True(result.Fault is null, result.ToString());
    }

    // A poster keeps what it has read of the demand for fences for ten steps: as long as that places are watched.
    private static ExplorationResult Explore(MemoryModel memory, SlotScenario scenario, SlotsUnderTest slots)
        => Explorer.Explore(
            new SlotModel(scenario, slots), new ExplorerOptions(memory) { WatchedSteps = WatchedSteps });
}
