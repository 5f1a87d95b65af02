namespace Rabit.Latency.Throughput;

/// <summary>A bounded ring under a lock, without Rabit.</summary>
internal sealed class LockedRing<T>(int capacity)
{
    private readonly object _gate = new();   // guards all below
    private readonly T[] _entries = new T[capacity];
    private int _head;
    private int _count;

    public bool TryPush(in T value)
    {
        lock (_gate)
        {
            if (_count == _entries.Length)
                return false;
            int tail = _head + _count;
            _entries[tail < _entries.Length ? tail : tail - _entries.Length] = value;
            _count++;
            return true;
        }
    }

    public bool TryPop(out T value)
    {
        lock (_gate)
        {
            if (_count == 0)
            {
                value = default!;
                return false;
            }

            value = _entries[_head];
            if (++_head == _entries.Length)
                _head = 0;
            _count--;
            return true;
        }
    }
}
