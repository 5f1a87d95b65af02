namespace Rabit.Core.Tests.Exploration;

/// <summary>How an exploration goes about it.</summary>
/// <param name="Memory">What the memory may show.</param>
internal sealed record ExplorerOptions(MemoryModel Memory)
{
    /// <summary>
    /// For how many steps a claim that two places in the code go on alike is watched (<see cref="CodeFold"/>); 0: none
    /// is made.
    /// </summary>
    public int WatchedSteps { get; init; } = 5;

    /// <summary>
    /// How many of the answers that lead to the same kind of operation are watched on, for those steps; the others for
    /// one step. All by default: their number grows with the power of the steps.
    /// </summary>
    public int WatchedAnswers { get; init; } = int.MaxValue;

    /// <summary>
    /// Whether a step that conflicts with no other is taken at once and alone (<see cref="LoneWriters"/>).
    /// </summary>
    public bool TakesFreeSteps { get; init; } = true;

    /// <summary>
    /// Whether a compare-and-swap that is tried until it succeeds is one step (<see cref="RetriedUpdates"/>).
    /// </summary>
    public bool MergesRetries { get; init; } = true;
}
