using System.Threading;

namespace Rabit.Latency.Throughput;

/// <summary>
/// As <see cref="SpscRing{T}"/>, and each entry says which position it holds: the receiver looks at nothing else, so
/// that no index goes between the processors unless the ring is full.
/// </summary>
internal sealed class SequencedSpscRing<T>
{
    private readonly Entry[] _entries;   // a power of two
    private RingSide _sender;
    private RingSide _receiver;

    public SequencedSpscRing(int capacity)
    {
        _entries = new Entry[capacity];
        for (int i = 0; i < capacity; i++)
            _entries[i].Position = i - capacity;
    }

    public bool TryPush(in T value)
    {
        int tail = _sender.Own;
        if (tail - _sender.SeenOther == _entries.Length)
        {
            _sender.SeenOther = Volatile.Read(ref _receiver.Own);
            if (tail - _sender.SeenOther == _entries.Length)
                return false;
        }

        ref Entry entry = ref _entries[tail & (_entries.Length - 1)];
        entry.Value = value;
        Volatile.Write(ref entry.Position, tail);
        _sender.Own = tail + 1;
        return true;
    }

    public bool TryPop(out T value)
    {
        int head = _receiver.Own;
        ref Entry entry = ref _entries[head & (_entries.Length - 1)];
        if (Volatile.Read(ref entry.Position) != head)
        {
            value = default!;
            return false;
        }

        value = entry.Value;
        Volatile.Write(ref _receiver.Own, head + 1);
        return true;
    }

    private struct Entry
    {
        public T Value;
        public int Position;
    }
}
