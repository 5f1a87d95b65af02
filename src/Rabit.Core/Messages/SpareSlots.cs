using System.Linq;
using System.Threading;

namespace Rabit.Core.Messages;

/// <summary>
/// The slots that belong to one poster, which alone writes them: first in, first out, so that one that was the latest
/// is written over as late as can be. For the poster's thread.
/// </summary>
/// <param name="indices">Where they are in the pool; the array is then this object's.</param>
/// <param name="isOutside">Whether only its documentation holds the poster to one thread.</param>
internal sealed class SpareSlots(int[] indices, bool isOutside)
{
    private int[] _indices = indices;
    private int _next;
    private int _isInUse;   // of a poster outside managers

    public int Count => _indices.Length;

    /// <summary>The slot whose turn it is.</summary>
    public int Next => _indices[_next];

    /// <summary>Leaves out one that cannot be written yet.</summary>
    public void Skip() => _next = _next + 1 == _indices.Length ? 0 : _next + 1;

    /// <summary>Exchanges the slot whose turn it was for one that is not the latest any more.</summary>
    public void Replace(int index)
    {
        _indices[_next] = index;
        Skip();
    }

    /// <summary>One more slot, whose turn it is.</summary>
    public void Add(int index) => _indices = [.. _indices.Take(_next), index, .. _indices.Skip(_next)];

    /// <returns>False when another thread is just posting through the same endpoint.</returns>
    public bool TryEnter() => !isOutside || Interlocked.Exchange(ref _isInUse, 1) == 0;

    public void Exit()
    {
        if (isOutside)
            Volatile.Write(ref _isInUse, 0);
    }
}
