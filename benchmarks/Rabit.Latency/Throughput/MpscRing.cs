using System.Threading;

namespace Rabit.Latency.Throughput;

/// <summary>
/// A ring for many senders and one receiver: the limit with two. Each entry says which position it is ready for (after
/// Dmitry Vyukov's bounded queue); nothing is counted, no manager is woken.
/// </summary>
internal sealed class MpscRing<T>
{
    private readonly Entry[] _entries;   // a power of two
    private RingSide _senders;
    private RingSide _receiver;

    public MpscRing(int capacity)
    {
        _entries = new Entry[capacity];
        for (int i = 0; i < capacity; i++)
            _entries[i].ReadyFor = i;
    }

    public bool TryPush(in T value)
    {
        while (true)
        {
            int tail = Volatile.Read(ref _senders.Own);
            ref Entry entry = ref _entries[tail & (_entries.Length - 1)];
            int ahead = Volatile.Read(ref entry.ReadyFor) - tail;
            if (ahead < 0)
                return false;
            if (ahead > 0 || Interlocked.CompareExchange(ref _senders.Own, tail + 1, tail) != tail)
                continue;
            entry.Value = value;
            Volatile.Write(ref entry.ReadyFor, tail + 1);
            return true;
        }
    }

    public bool TryPop(out T value)
    {
        int head = _receiver.Own;
        ref Entry entry = ref _entries[head & (_entries.Length - 1)];
        if (Volatile.Read(ref entry.ReadyFor) != head + 1)
        {
            value = default!;
            return false;
        }

        value = entry.Value;
        _receiver.Own = head + 1;
        Volatile.Write(ref entry.ReadyFor, head + _entries.Length);
        return true;
    }

    private struct Entry
    {
        public T Value;
        public int ReadyFor;
    }
}
