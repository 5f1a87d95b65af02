using System.Collections.Generic;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// What a thread does in answer to everything it may be received, found by running its code: a place in the tree is a
/// place in the code with all its local variables. The code is run to each place once.
/// </summary>
internal sealed class CodeTree(ExploredThread thread, Recorder recorder)
{
    private readonly Dictionary<object, CodePlace> _pieces = [];
    private readonly CodePlace _end = new(null, new SyncOperation(SyncKind.End), "", null, 0);

    public CodePlace Root => PieceFrom(thread.Begin);

    public CodePlace After(CodePlace place, int result)
    {
        var script = new List<(SyncOperation, int)> { (place.Operation, result) };
        CodePlace first = place;
        for (; first.Before is { } before; first = before)
            script.Add((before.Operation, first.Result));
        script.Reverse();
        return RunTo(place.From, script, place, result);
    }

    private CodePlace PieceFrom(object from)
    {
        if (!_pieces.TryGetValue(from, out CodePlace? place))
            _pieces.Add(from, place = RunTo(from, [], null, 0));
        return place;
    }

    private CodePlace RunTo(object from, List<(SyncOperation, int)> script, CodePlace? before, int result)
    {
        if (recorder.TryRun(() => thread.Run(from), script, out SyncOperation next, out object? rest))
            return new CodePlace(this, next, from, before, result);
        return rest is null ? _end : PieceFrom(rest);
    }
}
