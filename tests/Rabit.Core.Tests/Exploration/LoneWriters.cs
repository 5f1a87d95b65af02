using System.Collections.Generic;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Finds the locations that one thread writes and the others read at most, plainly or volatile. Such a write need not
/// wait for a step of its own.
/// </summary>
/// <remarks>
/// A plain write to such a location may be taken as soon as its thread comes to it, and nothing else is tried there.
/// Nothing is lost by that:
/// <list type="bullet">
/// <item>the others may be shown what was there before as long as they might have been without it, so whatever they do
/// before the write, they can do after it, and the state that is come to is the same;</item>
/// <item>a write is never in the way of its own thread: it can always be taken.</item>
/// </list>
/// So it is a left mover (Lipton: "Reduction", CACM 1975), and a set of steps that persists of one alone (Godefroid:
/// "Partial-order methods for the verification of concurrent systems", LNCS 1032, 1996); no state comes twice in one
/// run, so none is put off for ever. It needs a memory that may show old values: on a sequentially consistent one it is
/// not done.
/// That a location is one of these is not assumed but watched in all that is explored; where another thread breaks it,
/// the exploration begins again without. That is enough: the first step of a run that breaks it comes after steps that
/// do not, and these are explored in some order.
/// </remarks>
internal sealed class LoneWriters
{
    private const int Several = -1;

    private readonly Dictionary<int, int> _writers = [];
    private readonly HashSet<int> _relied = [];

    /// <summary>Whether a thread is the only writer of a location, as far as is known.</summary>
    public bool IsLone(int location, int thread)
    {
        if (_writers.TryGetValue(location, out int writer) && writer != thread)
            return false;
        _writers[location] = thread;
        _relied.Add(location);
        return true;
    }

    /// <summary>Notes a step that writes, or reads what is newest.</summary>
    /// <exception cref="CodeFold.ClaimBroken">
    /// The location was taken for one with a lone writer, and is none.
    /// </exception>
    public void Meet(int location, int thread)
    {
        if (!_writers.TryGetValue(location, out int writer))
            _writers.Add(location, thread);
        else if (writer != thread && writer != Several)
        {
            _writers[location] = Several;
            if (_relied.Remove(location))
                throw new CodeFold.ClaimBroken();
        }
    }
}
