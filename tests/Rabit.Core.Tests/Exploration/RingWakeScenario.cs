using System.Collections.Generic;

namespace Rabit.Core.Tests.Exploration;

/// <summary>Who pushes into the queue of a receiver that sleeps.</summary>
/// <param name="Pushes">How many values each sender has.</param>
/// <param name="Capacity">Of the queue.</param>
internal sealed record RingWakeScenario(IReadOnlyList<int> Pushes, int Capacity)
{
    /// <summary>
    /// Whether a sender whose push was rejected sleeps until a pop wakes it, and pushes again; else the value is lost.
    /// </summary>
    public bool SendersWait { get; init; }

    /// <summary>How many values a sender pushes at once, where it has as many left.</summary>
    public int Batch { get; init; } = 1;
}
