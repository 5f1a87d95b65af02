using System.Collections.Generic;
using System.Linq;

namespace Rabit.Core.Tests.Exploration;

/// <summary>Places in the code of a thread that go on alike, with one that stands for them all.</summary>
internal sealed class FoldedPlace(CodePlace place, int number)
{
    public CodePlace Place { get; } = place;

    public int Number { get; } = number;

    public bool IsEnd { get; } = place.Operation.Kind == SyncKind.End;

    public List<Answer> Next { get; } = [];

    /// <summary>The same, by what the thread is received.</summary>
    public Dictionary<int, FoldedPlace> ByAnswer { get; } = [];

    /// <summary>
    /// How many of the values of the location this place is known to be a retried update for; see
    /// <see cref="RetriedUpdates"/>.
    /// </summary>
    public int RetriesKnown { get; set; }

    /// <summary>The others, and for how many steps each is watched.</summary>
    public List<FoldClaim> Claims { get; } = [];

    /// <summary>Notes what comes after an answer.</summary>
    public Answer Add(int received, FoldedPlace place)
    {
        SyncOperation operation = place.Place.Operation;
        var answer = new Answer(received, place, Next.Count(
            n => n.Place.Place.Operation.Kind == operation.Kind
                && n.Place.Place.Operation.Location == operation.Location));
        Next.Add(answer);
        ByAnswer.Add(received, place);
        return answer;
    }

    /// <summary>An answer, and where it leads.</summary>
    /// <param name="Received">What the thread is received.</param>
    /// <param name="Place">Where it is then.</param>
    /// <param name="Rank">
    /// How many answers that lead to an operation of the same kind in the same location came up before this one.
    /// </param>
    internal readonly record struct Answer(int Received, FoldedPlace Place, int Rank);
}
