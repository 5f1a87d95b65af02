using System.Collections.Generic;

namespace Rabit.Core.Tests.Exploration;

/// <summary>Who pushes and pops in an exploration of a queue.</summary>
/// <param name="Pushes">How often each sender pushes.</param>
/// <param name="Pops">How often the receiver tries to pop.</param>
/// <param name="Capacity">Of the queue.</param>
internal sealed record RingScenario(IReadOnlyList<int> Pushes, int Pops, int Capacity)
{
    /// <summary>
    /// Whether what one has done is seen by all at once. Else a pop may miss a value whose push has returned, and a
    /// push be rejected for a value that was taken out, until a wake or a fence orders the two.
    /// </summary>
    public bool IsSeenAtOnce { get; init; }

    /// <summary>How many values one push or pop moves.</summary>
    public int Batch { get; init; } = 1;

    /// <summary>How often another thread reads the counters.</summary>
    public int Looks { get; init; }
}
