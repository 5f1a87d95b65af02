using System.Collections.Generic;

namespace Rabit.Core.Tests.Exploration;

/// <summary>A place in the code of a thread: what it was received on the way, and what it is about to do.</summary>
internal sealed class CodePlace(CodeTree? tree, SyncOperation operation, object from, CodePlace? before, int result)
{
    private readonly Dictionary<int, CodePlace> _next = [];

    /// <summary>Whose code it is; null at the end of a thread.</summary>
    public CodeTree? Tree { get; } = tree;

    public SyncOperation Operation { get; } = operation;

    /// <summary>What the piece of code began with.</summary>
    public object From { get; } = from;

    /// <summary>Null at the beginning of a piece, and at the end of the thread.</summary>
    public CodePlace? Before { get; } = before;

    /// <summary>What the place before was received.</summary>
    public int Result { get; } = result;

    public CodePlace After(int received)
    {
        if (!_next.TryGetValue(received, out CodePlace? place))
            _next.Add(received, place = Tree!.After(this, received));
        return place;
    }
}
