using System;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Units of work on readers (<see cref="RabitManager.RunsOnReaders"/>) in every interleaving of the code that flies, on
/// both wait engines: one turn at a time, each sees what the one before did, no wake and no stop is lost.
/// </summary>
public sealed class LoanExplorationTests(ITestOutputHelper output)
{
    // As in WakeUpExplorationTests.
    private const int WatchedAnswers = 2;

    [Theory, Trait("Clause", "1.1"), Trait("Clause", "1.4")]
    [InlineData("event", 1, 2, 1)]
    [InlineData("event", 2, 1, 0)]
    [InlineData("futex", 1, 2, 0)]
    [InlineData("futex", 2, 1, 0)]
    public void Loans_OfASleeperWithoutATimer_OneTurnAtATime(string engine, int readers, int valuesEach, int wakers)
        => AssertNoFault(
            engine, new LoanScenario(readers, valuesEach) { Wakers = wakers, EarlyReturns = 1 },
            MemoryModel.StoreBuffers);

    [Theory, Trait("Clause", "1.1"), Trait("Clause", "1.6")]
    [InlineData("event", false)]
    [InlineData("futex", false)]
    [InlineData("event", true)]
    [InlineData("futex", true)]
    public void Loans_UntilTheStop_OneTurnAtATime(string engine, bool wakesAfterLoans)
        => AssertNoFault(
            engine,
            new LoanScenario(1, 2) { Stops = true, Ticks = wakesAfterLoans ? 0 : 1, WakesAfterLoans = wakesAfterLoans },
            MemoryModel.StoreBuffers);

    [Theory, Trait("Clause", "1.1"), Trait("Clause", "1.6")]
    [InlineData("event")]
    [InlineData("futex")]
    public void Loans_OnAMemoryThatAlsoReadsEarly_OneTurnAtATime(string engine)
        => AssertNoFault(engine, new LoanScenario(1, 1) { Stops = true }, MemoryModel.Weak);

    [Fact, Trait("Category", "Long"), Trait("Clause", "1.1"), Trait("Clause", "1.6")]
    public void Loans_WithAWakerOnAMemoryThatAlsoReadsEarly_OneTurnAtATime()
        => AssertNoFault("event", new LoanScenario(1, 1) { Wakers = 1, Stops = true }, MemoryModel.Weak);

    [Theory, Trait("Category", "Long"), Trait("Clause", "1.1"), Trait("Clause", "1.6")]
    [InlineData("event", false)]
    [InlineData("futex", false)]
    [InlineData("event", true)]
    public void Loans_OfTwoReadersAndAWaker_OneTurnAtATime(string engine, bool wakesAfterLoans)
        => AssertNoFault(
            engine,
            new LoanScenario(2, 1)
            {
                Wakers = 1,
                Stops = true,
                Ticks = wakesAfterLoans ? 0 : 1,
                WakesAfterLoans = wakesAfterLoans,
            },
            MemoryModel.StoreBuffers);

    [Theory]
    [InlineData(SeededLoanFault.SleeperDoesNotTakeBack)]
    [InlineData(SeededLoanFault.TakesBackInTwoSteps)]
    [InlineData(SeededLoanFault.LoanEndsWithoutALook)]
    [InlineData(SeededLoanFault.LoanEndsWithoutASignal)]
    [InlineData(SeededLoanFault.SleeperWaitsUnnoticed)]
    [InlineData(SeededLoanFault.BorrowsTheAwake)]
    [InlineData(SeededLoanFault.BorrowerIgnoresTheStop)]
    public void Explore_SeededFault_IsFound(SeededLoanFault fault)
    {
        ExplorationResult result = ExploreFaulty(fault);

        output.WriteLine(result.ToString());
        Assert.NotNull(result.Fault);
        Assert.NotEmpty(result.Schedule);
    }

    [Fact]
    public void Explore_NoFault_FindsNone()
    {
        ExplorationResult result = ExploreFaulty(SeededLoanFault.None);

        output.WriteLine(result.ToString());
        Assert.Null(result.Fault);
    }

    private static ExplorationResult ExploreFaulty(SeededLoanFault fault)
        => Explorer.Explore(
            new LoanModel(
                new LoanScenario(1, 2) { Stops = true, EarlyReturns = 1, Ticks = 2 },
                clock => new FaultyLoan(fault, clock)),
            new ExplorerOptions(MemoryModel.StoreBuffers) { WatchedAnswers = WatchedAnswers });

    private void AssertNoFault(string engine, LoanScenario scenario, MemoryModel memory)
    {
        ExplorationResult result = Explorer.Explore(
            new LoanModel(scenario, ProductionLoan.On(engine)),
            new ExplorerOptions(memory) { WatchedAnswers = WatchedAnswers });
        output.WriteLine($"{engine}, {memory}: {scenario}");
        output.WriteLine(result.ToString());
        Assert.True(result.Fault is null, result.ToString());
    }
}
