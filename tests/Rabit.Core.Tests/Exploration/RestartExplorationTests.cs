using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Contract 1.4, 1.6 and 1.7 in every interleaving of the code that flies: wakes and a stop at any time of a restart,
/// from the fault through the back-off and the start-up to the first unit of work and the sleep after it.
/// </summary>
public sealed class RestartExplorationTests(ITestOutputHelper output)
{
    [Theory, Trait("Clause", "1.4"), Trait("Clause", "1.6"), Trait("Clause", "1.7")]
    [InlineData("event", 1, 2)]
    [InlineData("event", 2, 1)]
    [InlineData("futex", 1, 2)]
    public void Restart_WakesAndAStopAtAnyTime_AreInTheUnitAfterIt(string engine, int wakers, int wakesEach)
        => AssertNoFault(engine, wakers, wakesEach, MemoryModel.StoreBuffers);

    [Theory, Trait("Category", "Long"), Trait("Clause", "1.4"), Trait("Clause", "1.6"), Trait("Clause", "1.7")]
    [InlineData("event", 2, 2, false)]
    [InlineData("futex", 2, 1, false)]
    [InlineData("event", 1, 2, true)]
    [InlineData("futex", 1, 1, true)]
    public void Restart_MoreWakesOrAMemoryThatReadsEarly_AreInTheUnitAfterIt(
        string engine, int wakers, int wakesEach, bool isWeak)
        => AssertNoFault(engine, wakers, wakesEach, isWeak ? MemoryModel.Weak : MemoryModel.StoreBuffers);

    [Theory]
    [InlineData(SeededRestartFault.EarlierWakesForgotten, "a wake that had returned is not in the turn")]
    [InlineData(SeededRestartFault.WakesOfTheStartUpForgotten, "a wake was lost: the sleeper goes on sleeping")]
    [InlineData(SeededRestartFault.RunsInTheSameStep, "a turn began after a stop had returned")]
    [InlineData(SeededRestartFault.WakeEndsTheBackOff, "a start-up in the back-off")]
    public void Restart_SeededFault_IsFound(SeededRestartFault fault, string expected)
    {
        WakeUpScenario scenario = Scenario(wakers: 1, wakesEach: 1) with
        {
            Stops = fault == SeededRestartFault.RunsInTheSameStep,
        };

        ExplorationResult result = Explorer.Explore(
            new WakeUpModel(scenario, ProductionWakeUp.OnEvent, fault), MemoryModel.SequentiallyConsistent);

        output.WriteLine(result.ToString());
        Assert.Equal(expected, result.Fault);
    }

    // Time may pass once more, during the start-up: so there is a moment in it when others may do something.
    private static WakeUpScenario Scenario(int wakers, int wakesEach)
        => new(wakers, wakesEach) { Restarts = true, Stops = true, Ticks = 2, EarlyReturns = 1 };

    private void AssertNoFault(string engine, int wakers, int wakesEach, MemoryModel memory)
    {
        ExplorationResult result = Explorer.Explore(
            new WakeUpModel(Scenario(wakers, wakesEach), ProductionWakeUp.On(engine)), memory);
        output.WriteLine(result.ToString());
        Assert.True(result.Fault is null, result.ToString());
    }
}
