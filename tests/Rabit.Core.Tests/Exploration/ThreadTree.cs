using System.Collections.Generic;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// What a thread does in answer to everything it may be told, found by running its code: a place in the tree is a place in the code with
/// all its local variables. Each place is run to once; exploring is then walking.
/// </summary>
internal sealed class ThreadTree(ExploredThread thread, Recorder recorder, List<ThreadTree.Place> places)
{
    private readonly Dictionary<object, Place> _pieces = [];
    private Place? _end;

    public Place Root => PieceFrom(thread.Begin);

    public Place After(Place place, int result)
    {
        foreach ((int known, Place next) in place.Next)
        {
            if (known == result)
                return next;
        }

        var script = new List<(SyncOperation, int)> { (place.Operation, result) };
        Place first = place;
        for (; first.Before is { } before; first = before)
            script.Add((before.Operation, first.Result));
        script.Reverse();

        Place found = RunTo(first.From, script, place, result);
        place.Next.Add((result, found));
        return found;
    }

    private Place PieceFrom(object from)
    {
        if (!_pieces.TryGetValue(from, out Place? place))
            _pieces.Add(from, place = RunTo(from, [], null, 0));
        return place;
    }

    private Place RunTo(object from, List<(SyncOperation, int)> script, Place? before, int result)
    {
        if (recorder.TryRun(() => thread.Run(from), script, out SyncOperation next, out object? rest))
            return Add(new Place(this, next, from, before, result, places.Count));
        if (rest is not null)
            return PieceFrom(rest);
        return _end ??= Add(new Place(this, new SyncOperation(SyncKind.End), from, null, 0, places.Count));
    }

    private Place Add(Place place)
    {
        places.Add(place);
        return place;
    }

    /// <summary>A place in the code of a thread, by what it is about to do.</summary>
    internal sealed class Place(ThreadTree tree, SyncOperation operation, object from, Place? before, int result, int number)
    {
        public SyncOperation Operation { get; } = operation;

        public object From { get; } = from;

        public Place? Before { get; } = before;

        /// <summary>What the place before was told.</summary>
        public int Result { get; } = result;

        public int Number { get; } = number;

        public List<(int Result, Place Place)> Next { get; } = [];

        public Place After(int told) => tree.After(this, told);
    }
}
