using System.Collections.Generic;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Keeps samples of a run of any length: when it is full every second one goes, and from then on only half as many
/// are taken.
/// </summary>
internal sealed class DecimatedSeries<T>(int capacity)
{
    private readonly List<T> _items = [];
    private long _offered;
    private long _stride = 1;

    public int Count => _items.Count;

    public void Add(T item)
    {
        if (_offered++ % _stride != 0)
            return;
        if (_items.Count == capacity)
        {
            Thin();
            if ((_offered - 1) % _stride != 0)
                return;
        }

        _items.Add(item);
    }

    public T[] ToArray() => _items.ToArray();

    private void Thin()
    {
        int kept = 0;
        for (int index = 0; index < _items.Count; index += 2)
            _items[kept++] = _items[index];
        _items.RemoveRange(kept, _items.Count - kept);
        _stride *= 2;
    }
}
