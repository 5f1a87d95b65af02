using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Runs a piece of code up to its next synchronisation point: the points before it get the results that the script
/// gives them; at the next one the code is left. So a thread needs no thread, and its state is what it was received so
/// far.
/// </summary>
/// <remarks>
/// A location is known by a number that is written into it when it is first met; what it holds at any time is the
/// explorer's business.
/// </remarks>
internal sealed class Recorder
{
    private const int Tag = 0x5AFE_4500;
    private const int TagMask = unchecked((int)0xFFFF_FF00);

    private readonly List<int> _initialValues = [];
    private readonly List<AutoResetEvent> _signals = [];
    private IReadOnlyList<(SyncOperation Operation, int Result)> _script = [];
    private int _position;
    private SyncOperation _next;

    /// <summary>The recorder of the code that runs on this thread; null where nothing is explored.</summary>
    [field: ThreadStatic]
    public static Recorder? Current { get; private set; }

    /// <summary>Runs a piece of code with what its points answered so far.</summary>
    /// <param name="code">Returns what it begins with next time, or null at its end.</param>
    /// <param name="script">What it did so far, and what it was received.</param>
    /// <param name="next">The operation at which it was left; default where it came to its end.</param>
    /// <param name="rest">What the code returned.</param>
    /// <returns>False where the code came to its end.</returns>
    public bool TryRun(
        Func<object?> code, IReadOnlyList<(SyncOperation Operation, int Result)> script, out SyncOperation next,
        out object? rest)
    {
        (_script, _position, _next, rest) = (script, 0, default, null);
        Current = this;
        try
        {
            rest = code();
        }
        catch (Left)
        {
            next = _next;
            return true;
        }
        catch (PieceEnded ended)
        {
            rest = ended.Rest;
        }
        finally
        {
            Current = null;
        }

        next = default;
        return false;
    }

    /// <summary>Ends the piece of code from inside a call.</summary>
    public static Exception End(object? rest) => new PieceEnded(rest);

    public int Perform(in SyncOperation operation)
    {
        if (_position == _script.Count)
        {
            _next = operation;
            throw new Left();
        }

        (SyncOperation before, int result) = _script[_position++];
        if (!before.IsLike(operation))
            throw new InvalidOperationException(
                $"The code did {operation} where it did {before} before: it depends on something that is no "
                    + "synchronisation point.");
        return result;
    }

    /// <summary>The results of the volatile reads of a location up to where the code is.</summary>
    public IEnumerable<int> ReadsOf(int location)
        => _script.Take(_position)
            .Where(s => s.Operation.Kind == SyncKind.VolatileRead && s.Operation.Location == location)
            .Select(s => s.Result);

    public int InitialValue(int location) => location < _initialValues.Count ? _initialValues[location] : 0;

    public int LocationOf(ref int location)
    {
        if ((location & TagMask) == Tag)
            return location & ~TagMask;
        _initialValues.Add(location);
        location = Tag | (_initialValues.Count - 1);
        return _initialValues.Count - 1;
    }

    public int LocationOf(ref long location)
    {
        if ((location >> 32) == Tag)
            return (int)location;
        _initialValues.Add(ExploredSyncPoints.Number(location));
        location = ((long)Tag << 32) | (uint)(_initialValues.Count - 1);
        return _initialValues.Count - 1;
    }

    public int SignalOf(AutoResetEvent signal)
    {
        int known = _signals.FindIndex(s => ReferenceEquals(s, signal));
        if (known >= 0)
            return known;
        _signals.Add(signal);
        return _signals.Count - 1;
    }

    private sealed class Left : Exception;

    private sealed class PieceEnded(object? rest) : Exception
    {
        public object? Rest { get; } = rest;
    }
}
