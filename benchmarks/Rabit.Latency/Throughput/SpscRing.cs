using System;
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

    public int PushFrom(ReadOnlySpan<T> values)
    {
        int tail = _sender.Own;
        int free = _entries.Length - (tail - _sender.SeenOther);
        if (free < values.Length)
        {
            _sender.SeenOther = Volatile.Read(ref _receiver.Own);
            free = _entries.Length - (tail - _sender.SeenOther);
        }

        int count = Math.Min(free, values.Length);
        int place = tail & (_entries.Length - 1);
        int first = Math.Min(count, _entries.Length - place);
        values.Slice(0, first).CopyTo(_entries.AsSpan(place));
        values.Slice(first, count - first).CopyTo(_entries);
        Volatile.Write(ref _sender.Own, tail + count);
        return count;
    }

    public int PopInto(Span<T> target)
    {
        int head = _receiver.Own;
        if (_receiver.SeenOther - head < target.Length)
            _receiver.SeenOther = Volatile.Read(ref _sender.Own);
        int count = Math.Min(_receiver.SeenOther - head, target.Length);
        int place = head & (_entries.Length - 1);
        int first = Math.Min(count, _entries.Length - place);
        _entries.AsSpan(place, first).CopyTo(target);
        _entries.AsSpan(0, count - first).CopyTo(target.Slice(first));
        Volatile.Write(ref _receiver.Own, head + count);
        return count;
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
