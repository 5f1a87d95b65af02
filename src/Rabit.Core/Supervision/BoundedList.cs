using System.Collections.Generic;

namespace Rabit.Core.Supervision;

/// <summary>
/// Counts things and keeps the first ten: a manager that always throws must not fill the memory. Any thread.
/// </summary>
internal sealed class BoundedList<T>
{
    private const int Kept = 10;

    private readonly object _gate = new();
    private readonly List<T> _first = [];   // under _gate
    private long _count;                    // same

    public void Add(T item)
    {
        lock (_gate)
        {
            _count++;
            if (_first.Count < Kept)
                _first.Add(item);
        }
    }

    public IReadOnlyList<T> Read(out long count)
    {
        lock (_gate)
        {
            count = _count;
            return _first.ToArray();
        }
    }
}
