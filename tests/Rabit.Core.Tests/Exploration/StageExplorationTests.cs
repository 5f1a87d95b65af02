using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

/// <summary>Contract 4.5 in every interleaving of the mark by which the watchdog finds a manager that hangs.</summary>
public sealed class StageExplorationTests(ITestOutputHelper output)
{
    [Theory, Trait("Clause", "4.5")]
    [InlineData("SequentiallyConsistent", 3, 3)]
    [InlineData("StoreBuffers", 3, 3)]
    [InlineData("Weak", 3, 3)]
    public void Hang_FoundInEveryInterleaving_IsKnownToTheManagerThatLeaves(string memory, int stages, int looks)
    {
        ExplorationResult result = Explore(memory, new ProductionStageMark(), stages, looks);

        output.WriteLine(result.ToString());
        Assert.True(result.Fault is null, result.ToString());
    }

    /// <summary>That the exploration finds what it is for.</summary>
    [Theory]
    [InlineData(SeededStageFault.MarkWithoutASwap)]
    [InlineData(SeededStageFault.LeaveWithoutAnExchange)]
    [InlineData(SeededStageFault.TimeAfterTheStage)]
    [InlineData(SeededStageFault.OneLook)]
    [InlineData(SeededStageFault.NoNumber)]
    public void Exploration_OfATwinWithAFault_FindsIt(SeededStageFault fault)
    {
        ExplorationResult right = Explore("Weak", new FaultyStageMark(SeededStageFault.None), 3, 2);
        ExplorationResult wrong = Explore("Weak", new FaultyStageMark(fault), 3, 2);

        output.WriteLine(wrong.ToString());
        Assert.True(right.Fault is null, right.ToString());
        Assert.NotNull(wrong.Fault);
    }

    private static ExplorationResult Explore(string memory, StageMarkUnderTest mark, int stages, int looks)
        => Explorer.Explore(
            new StageModel(mark, stages, looks),
            new ExplorerOptions(MemoryModels.Named(memory)) { WatchedSteps = 0 });
}
