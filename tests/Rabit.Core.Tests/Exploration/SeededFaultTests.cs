using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// The explorer can fail: it finds each fault that is put into a wake-up, and prints the schedule that shows it.
/// </summary>
public sealed class SeededFaultTests(ITestOutputHelper output)
{
    [Theory]
    [InlineData(SeededFault.FlagClearedAfterTheWork)]
    [InlineData(SeededFault.FlagClearedByAPlainWrite)]
    [InlineData(SeededFault.FlagSetAfterTheSignal)]
    [InlineData(SeededFault.WaitWithoutRecheck)]
    [InlineData(SeededFault.WakeDroppedDuringStartup)]
    [InlineData(SeededFault.UnfencedAlreadySetRead)]
    [InlineData(SeededFault.StopWithoutASignal)]
    [InlineData(SeededFault.WakesThatStack)]
    public void Explore_SeededFault_IsFound(SeededFault fault)
    {
        ExplorationResult result = Explore(fault, MemoryModel.StoreBuffers);

        output.WriteLine(result.ToString());
        Assert.NotNull(result.Fault);
        Assert.NotEmpty(result.Schedule);
    }

    [Fact]
    public void Explore_NoFault_FindsNone()
    {
        ExplorationResult result = Explore(SeededFault.None, MemoryModel.StoreBuffers);

        output.WriteLine(result.ToString());
        Assert.Null(result.Fault);
    }

    /// <summary>
    /// Only a memory with store buffers shows it: an explorer that interleaves and no more would pass it.
    /// </summary>
    [Fact]
    public void Explore_UnfencedReadOnASequentiallyConsistentMemory_FindsNone()
        => Assert.Null(Explorer.Explore(
            new WakeUpModel(
                new WakeUpScenario(1, 2) { ChecksCounts = false },
                clock => new FaultyWakeUp(SeededFault.UnfencedAlreadySetRead, clock)),
            MemoryModel.SequentiallyConsistent).Fault);

    [Fact]
    public void Explore_UnfencedReadOnStoreBuffers_FindsALostPost()
    {
        ExplorationResult result = Explorer.Explore(
            new WakeUpModel(
                new WakeUpScenario(1, 2) { ChecksCounts = false },
                clock => new FaultyWakeUp(SeededFault.UnfencedAlreadySetRead, clock)),
            MemoryModel.StoreBuffers);

        output.WriteLine(result.ToString());
        Assert.Equal("a turn does not see what was written before its wake", result.Fault);
    }

    internal static WakeUpScenario ScenarioOf(SeededFault fault)
        => new(1, 2)
        {
            Starts = true,
            Stops = fault is SeededFault.StopWithoutASignal or SeededFault.None,
            ChecksCounts = fault != SeededFault.UnfencedAlreadySetRead,
        };

    private static ExplorationResult Explore(SeededFault fault, MemoryModel memory)
        => Explorer.Explore(new WakeUpModel(ScenarioOf(fault), clock => new FaultyWakeUp(fault, clock)), memory);
}
