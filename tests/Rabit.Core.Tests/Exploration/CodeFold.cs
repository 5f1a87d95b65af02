using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Folds the places of a thread's code that go on alike, however they were reached: a loop that tries again comes back
/// to where it was.
/// </summary>
/// <remarks>
/// Two places of one piece that are about to do the same are claimed to be alike. The claim is watched: whatever the
/// thread is received at the one, in the whole exploration, its code is run with at the other too, and must do the same
/// for some steps on. A claim that breaks is never made again, and the exploration begins again. This is how a program
/// is tested against an automaton (Chow: "Testing software design modeled by finite-state machines", IEEE TSE 1978): it
/// is exact unless the code hides a difference for longer than it is watched. What is watched grows with the number of
/// answers to the power of the steps. So a large exploration follows, from each place, only a few answers that lead to
/// the same kind of operation for all the steps; the others are watched for one step.
/// Tests explore without folding, with all answers and with few, and find the same number of interleavings.
/// </remarks>
internal sealed class CodeFold(int watchedSteps, int watchedAnswers)
{
    private readonly List<FoldedPlace> _places = [];
    private readonly Dictionary<(CodeTree? Tree, object From, SyncOperation Operation), List<FoldedPlace>> _alike = [];
    private readonly Dictionary<CodePlace, FoldedPlace> _exact = [];
    private readonly HashSet<(CodePlace, CodePlace)> _unlike = [];

    public FoldedPlace this[int number] => _places[number];

    /// <summary>Forgets all but which places are not alike.</summary>
    public void Restart()
    {
        _places.Clear();
        _alike.Clear();
        _exact.Clear();
    }

    public FoldedPlace PlaceOf(CodePlace place)
    {
        if (_exact.TryGetValue(place, out FoldedPlace? known))
            return known;

        var key = (place.Tree, place.From, place.Operation with { Note = null });
        if (!_alike.TryGetValue(key, out List<FoldedPlace>? alike))
            _alike.Add(key, alike = []);
        FoldedPlace? found = watchedSteps == 0 || place.Before is null
            ? null
            : alike.FirstOrDefault(a => !_unlike.Contains((a.Place, place)) && GoOnAlike(a, place, watchedSteps));
        if (found is null)
        {
            found = new FoldedPlace(place, _places.Count);
            _places.Add(found);
            alike.Add(found);
        }
        else
        {
            Watch(found, new FoldClaim(place, watchedSteps, found.Place, place));
        }

        _exact.Add(place, found);
        return found;
    }

    /// <exception cref="ClaimBroken">Two places that were taken for alike are not.</exception>
    public FoldedPlace After(FoldedPlace place, int received)
    {
        if (place.ByAnswer.TryGetValue(received, out FoldedPlace? known))
            return known;

        FoldedPlace after = PlaceOf(place.Place.After(received));
        FoldedPlace.Answer answer = place.Add(received, after);
        foreach (FoldClaim claim in place.Claims.ToArray())
            Follow(claim, answer);
        return after;
    }

    private void Follow(FoldClaim claim, in FoldedPlace.Answer answer)
    {
        CodePlace there = claim.Place.After(answer.Received);
        int steps = StepsAfter(answer, claim.Steps);
        if (!GoOnAlike(answer.Place, there, steps))
        {
            _unlike.Add((claim.First, claim.Second));
            throw new ClaimBroken();
        }

        Watch(answer.Place, claim with { Place = there, Steps = steps });
    }

    private int StepsAfter(in FoldedPlace.Answer answer, int steps) => answer.Rank < watchedAnswers ? steps - 1 : 0;

    private bool GoOnAlike(FoldedPlace folded, CodePlace place, int steps)
    {
        if (ReferenceEquals(folded.Place, place))
            return true;
        if (folded.Place.Tree != place.Tree || !folded.Place.Operation.IsLike(place.Operation)
            || !folded.Place.From.Equals(place.From) || place.Operation.Kind == SyncKind.End)
            return false;
        return steps == 0
            || folded.Next.TrueForAll(
                next => GoOnAlike(next.Place, place.After(next.Received), StepsAfter(next, steps)));
    }

    private void Watch(FoldedPlace folded, FoldClaim claim)
    {
        if (claim.Steps == 0 || ReferenceEquals(folded.Place, claim.Place))
            return;
        folded.Claims.Add(claim);
        foreach (FoldedPlace.Answer next in folded.Next)
            Watch(
                next.Place,
                claim with { Place = claim.Place.After(next.Received), Steps = StepsAfter(next, claim.Steps) });
    }

    internal sealed class ClaimBroken : Exception;
}
