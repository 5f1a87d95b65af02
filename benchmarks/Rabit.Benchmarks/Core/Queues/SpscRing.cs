using System.Threading;

namespace Rabit.Benchmarks.Core.Queues;

/// <summary>The limit for one sender and one receiver: a ring without books, wakes or checks of who calls.</summary>
internal sealed class SpscRing<T>(int capacity)
{
    private readonly T[] _ring = new T[capacity];   // a power of two
    private SpscPositions _at;

    public bool TryPush(in T value)
    {
        int tail = _at.Tail;
        if (tail - _at.SeenHead == _ring.Length && tail - (_at.SeenHead = Volatile.Read(ref _at.Head)) == _ring.Length)
            return false;
        _ring[tail & (_ring.Length - 1)] = value;
        Volatile.Write(ref _at.Tail, tail + 1);
        return true;
    }

    public bool TryPop(out T value)
    {
        int head = _at.Head;
        value = default!;
        if (head == _at.SeenTail && head == (_at.SeenTail = Volatile.Read(ref _at.Tail)))
            return false;
        value = _ring[head & (_ring.Length - 1)];
        Volatile.Write(ref _at.Head, head + 1);
        return true;
    }
}
