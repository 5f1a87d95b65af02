using System.Collections.Generic;

namespace Rabit.Core.Tests.Exploration;

/// <summary>Places in the code of a thread that go on alike, with one that stands for them all.</summary>
internal sealed class FoldedPlace(CodePlace place, int number)
{
    public CodePlace Place { get; } = place;

    public int Number { get; } = number;

    public List<(int Told, FoldedPlace Place)> Next { get; } = [];

    /// <summary>The others, and for how many steps each is watched.</summary>
    public List<FoldClaim> Claims { get; } = [];
}
