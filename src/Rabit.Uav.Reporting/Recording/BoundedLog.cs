using System.Collections.Generic;

namespace Rabit.Uav.Reporting;

/// <summary>The first entries of something, and a count of those that had no room.</summary>
internal sealed class BoundedLog<T>(int capacity)
{
    private readonly List<T> _entries = [];

    public long LeftOut { get; private set; }

    public void Add(in T entry)
    {
        if (_entries.Count < capacity)
            _entries.Add(entry);
        else
            LeftOut++;
    }

    public T[] ToArray() => _entries.ToArray();
}
