using System.Collections.Generic;

namespace Rabit.Core.Tests.Exploration;

/// <summary>A place in the code of a thread: what it was told on the way, and what it is about to do.</summary>
internal sealed class CodePlace(CodeTree? tree, SyncOperation operation, object from, CodePlace? before, int result)
{
    private readonly Dictionary<int, CodePlace> _next = [];

    public SyncOperation Operation { get; } = operation;

    /// <summary>What the piece of code began with.</summary>
    public object From { get; } = from;

    /// <summary>Null at the beginning of a piece, and at the end of the thread.</summary>
    public CodePlace? Before { get; } = before;

    /// <summary>What the place before was told.</summary>
    public int Result { get; } = result;

    public CodePlace After(int told)
    {
        if (!_next.TryGetValue(told, out CodePlace? place))
            _next.Add(told, place = tree!.After(this, told));
        return place;
    }
}
