using System.Threading;

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
            if (++_count == 1)
                Monitor.Pulse(_gate);
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

            value = TakeOut();
            return true;
        }
    }

    /// <summary>Sleeps while it is empty. Senders wake with Pulse, which costs little where none waits.</summary>
    public T Pop()
    {
        lock (_gate)
        {
            while (_count == 0)
                Monitor.Wait(_gate);
            return TakeOut();
        }
    }

    // Under _gate.
    private T TakeOut()
    {
        T value = _entries[_head];
        if (++_head == _entries.Length)
            _head = 0;
        _count--;
        return value;
    }
}
