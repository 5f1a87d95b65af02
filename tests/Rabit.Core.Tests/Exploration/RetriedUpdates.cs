using System.Collections.Generic;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Finds reads that begin an update: read a location, compare-and-swap it, and where that fails go on as if the value
/// that it found had been read at first. Such an update is one step: the newest value is read and changed.
/// </summary>
/// <remarks>
/// Nothing is lost by that. A run in which the swap fails is, for all others, a run in which the thread read later;
/// what the failed swap does beside, being a fence, is to hurry the thread's own writes, and that only takes choices
/// from the others. That the code is of that kind is not assumed but tried with every value that the location has ever
/// had, up to what it does after the swap; where a new value shows otherwise, the exploration begins again without.
/// </remarks>
internal sealed class RetriedUpdates
{
    private readonly Dictionary<int, List<int>> _values = [];
    private readonly HashSet<(int Location, int Value)> _met = [];
    private readonly HashSet<CodePlace> _others = [];

    public void Restart()
    {
        _values.Clear();
        _met.Clear();
    }

    /// <summary>Notes a value of a location.</summary>
    public void Meet(int location, int value)
    {
        if (!_met.Add((location, value)))
            return;
        if (!_values.TryGetValue(location, out List<int>? values))
            _values.Add(location, values = []);
        values.Add(value);
    }

    /// <summary>Whether a place begins an update of a location that holds a value.</summary>
    /// <exception cref="CodeFold.ClaimBroken">It was taken for one, and is none.</exception>
    public bool IsOne(FoldedPlace place, int value)
    {
        SyncOperation read = place.Place.Operation;
        if (read.Kind is not (SyncKind.Read or SyncKind.VolatileRead) || _others.Contains(place.Place))
            return false;
        Meet(read.Location, value);
        List<int> values = _values[read.Location];
        for (int known = place.RetriesKnown; known < values.Count; known++)
        {
            int one = values[known];
            if (Retries(place.Place, one, values[0]) && Retries(place.Place, values[0], one)
                && Retries(place.Place, values[known / 2], one))
                continue;
            _others.Add(place.Place);
            if (place.RetriesKnown > 0)
                throw new CodeFold.ClaimBroken();
            return false;
        }

        place.RetriesKnown = values.Count;
        return true;
    }

    // Whether the code, received one value and then that another was found, does what it does when it is received the
    // other at once.
    private static bool Retries(CodePlace place, int received, int found)
    {
        CodePlace swap = place.After(received);
        CodePlace atOnce = place.After(found);
        if (!IsSwapOf(swap, place, received) || !IsSwapOf(atOnce, place, found))
            return false;
        if (received == found)
            return true;
        CodePlace again = swap.After(found);
        return again.Operation.IsLike(atOnce.Operation)
            && again.After(found).Operation.IsLike(atOnce.After(found).Operation);
    }

    private static bool IsSwapOf(CodePlace swap, CodePlace place, int received)
        => swap.Operation.Kind == SyncKind.CompareExchange
            && swap.Operation.Location == place.Operation.Location
            && swap.Operation.Comparand == received;
}
