namespace Rabit.Core.Tests.Exploration;

/// <summary>How much happens around a sleeper that lends itself.</summary>
/// <param name="Readers">Threads that borrow it where they can, and wake it where they cannot.</param>
/// <param name="ValuesEach">How often each of them does.</param>
internal sealed record LoanScenario(int Readers, int ValuesEach)
{
    /// <summary>Threads that wake it once each, and never borrow it.</summary>
    public int Wakers { get; init; }

    /// <summary>Whether the reactor stops the sleeper.</summary>
    public bool Stops { get; init; }

    /// <summary>How often time passes by as much as the timer waits; 0: the timer never comes.</summary>
    public int Ticks { get; init; }

    /// <summary>How often a wait returns without a reason.</summary>
    public int EarlyReturns { get; init; }

    /// <summary>Whether every work of a borrower ends by waking the sleeper; without a timer.</summary>
    public bool WakesAfterLoans { get; init; }

    /// <summary>What is checked of wakes is that of a sleeper without loans.</summary>
    public WakeUpScenario ForWakeUps
        => new(Readers + Wakers, ValuesEach) { Stops = Stops, Starts = Stops, Ticks = Ticks };
}
