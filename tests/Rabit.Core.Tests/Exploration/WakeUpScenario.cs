namespace Rabit.Core.Tests.Exploration;

/// <summary>How much happens around the sleeper.</summary>
/// <param name="Wakers">Threads that wake it.</param>
/// <param name="WakesEach">How often each of them does.</param>
internal sealed record WakeUpScenario(int Wakers, int WakesEach)
{
    /// <summary>Whether the sleeper begins at the start-up barrier, and the reactor opens it.</summary>
    public bool Starts { get; init; }

    /// <summary>Whether the reactor stops the sleeper.</summary>
    public bool Stops { get; init; }

    /// <summary>How often time passes by as much as the timer waits; 0: the timer never comes.</summary>
    public int Ticks { get; init; }

    /// <summary>How often a wait returns without a reason.</summary>
    public int EarlyReturns { get; init; }

    /// <summary>Whether turns are checked for all wakes and causes, or only for what they see.</summary>
    public bool ChecksCounts { get; init; } = true;

    /// <summary>
    /// Whether a turn reads what the wakers wrote step by step, or asks for the oldest that it might be shown.
    /// </summary>
    public bool ReadsInSteps { get; init; }

    /// <summary>
    /// Whether every turn fails, so that the next comes with the timer and not before, and wakes are kept.
    /// </summary>
    public bool BacksOff { get; init; }

    /// <summary>
    /// Whether the sleeper's last unit of work threw, so that it is restarted after the timer, and then runs.
    /// </summary>
    public bool Restarts { get; init; }
}
