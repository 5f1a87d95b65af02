using System.Diagnostics.CodeAnalysis;
using System.Threading;

namespace Rabit.Benchmarks.Core;

/// <summary>A bounded queue under a lock, the baseline: the waiting forms sleep while it is full or empty.</summary>
internal sealed class MonitorQueue<T>(int capacity)
{
    private readonly object _gate = new();
    private readonly T[] _ring = new T[capacity];
    private int _head;
    private int _count;

    public bool TryPush(in T value)
    {
        lock (_gate)
        {
            if (_count == _ring.Length)
                return false;
            PutIn(value);
            return true;
        }
    }

    public bool TryPop([MaybeNullWhen(false)] out T value)
    {
        lock (_gate)
        {
            value = default;
            if (_count == 0)
                return false;
            value = TakeOut();
            return true;
        }
    }

    public void Push(in T value)
    {
        lock (_gate)
        {
            while (_count == _ring.Length)
                Monitor.Wait(_gate);
            PutIn(value);
            if (_count == 1)
                Monitor.PulseAll(_gate);
        }
    }

    public T Pop()
    {
        lock (_gate)
        {
            while (_count == 0)
                Monitor.Wait(_gate);
            T value = TakeOut();
            if (_count == _ring.Length - 1)
                Monitor.PulseAll(_gate);
            return value;
        }
    }

    private void PutIn(in T value)
    {
        _ring[(_head + _count++) % _ring.Length] = value;
    }

    private T TakeOut()
    {
        T value = _ring[_head];
        _head = (_head + 1) % _ring.Length;
        _count--;
        return value;
    }
}
