using System.Collections.Generic;
using System.Linq;

namespace Rabit.Core.Tests.Exploration;

/// <summary>Who posts and fetches in an exploration of slots.</summary>
/// <param name="Posts">How often each poster posts.</param>
/// <param name="Fetchers">How many fetch.</param>
/// <param name="Fetches">How often each of them does.</param>
/// <param name="Tries">How often a fetch reads optimistically before it pins.</param>
internal sealed record SlotScenario(IReadOnlyList<int> Posts, int Fetchers, int Fetches, int Tries)
{
    public bool IsAlone => Posts.Count == 1;

    public int Slots => 1 + (Posts.Count * Spares);

    /// <summary>
    /// How many spares each poster has: by default more than fetchers can pin at once, so that the pool does not grow.
    /// </summary>
    public int Spares { get; init; } = Fetchers + 1;

    public IEnumerable<int> SparesOf(int poster) => Enumerable.Range(1 + (poster * Spares), Spares);
}
