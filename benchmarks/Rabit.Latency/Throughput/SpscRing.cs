using System.Threading;

namespace Rabit.Latency.Throughput;

/// <summary>
/// A ring for one sender and one receiver: the limit. Each side keeps what it last saw of the other, and looks again
/// only when that says full or empty (Lee, Bu, Chandranmenon: "A Lock-Free, Cache-Efficient Shared Ring Buffer for
/// Multi-Core Architectures", ANCS 2009).
/// </summary>
internal sealed class SpscRing<T>(int capacity)
{
    private readonly T[] _entries = new T[capacity];   // a power of two
    private RingSide _sender;
    private RingSide _receiver;

    public bool TryPush(in T value)
    {
        int tail = _sender.Own;
        if (tail - _sender.SeenOther == _entries.Length)
        {
            _sender.SeenOther = Volatile.Read(ref _receiver.Own);
            if (tail - _sender.SeenOther == _entries.Length)
                return false;
        }

        _entries[tail & (_entries.Length - 1)] = value;
        Volatile.Write(ref _sender.Own, tail + 1);
        return true;
    }

    public bool TryPop(out T value)
    {
        int head = _receiver.Own;
        if (head == _receiver.SeenOther)
        {
            _receiver.SeenOther = Volatile.Read(ref _sender.Own);
            if (head == _receiver.SeenOther)
            {
                value = default!;
                return false;
            }
        }

        value = _entries[head & (_entries.Length - 1)];
        Volatile.Write(ref _receiver.Own, head + 1);
        return true;
    }
}
