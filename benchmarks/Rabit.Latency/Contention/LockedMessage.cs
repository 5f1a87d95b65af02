using System.Threading;

namespace Rabit.Latency.Contention;

/// <summary>A message without Rabit: a lock and a version, which the fetcher reads before it takes the lock.</summary>
internal sealed class LockedMessage<T>(T initial)
{
    private readonly object _gate = new();   // guards _shared; _version is written under it, read by all
    private T _shared = initial;
    private T _fetched = initial;            // the fetcher's
    private int _version;
    private int _seen;                       // the fetcher's

    public void Post(in T value)
    {
        lock (_gate)
        {
            _shared = value;
            _version++;
        }
    }

    public bool Fetch(out T value)
    {
        value = _fetched;
        if (Volatile.Read(ref _version) == _seen)
            return false;
        lock (_gate)
        {
            _fetched = _shared;
            _seen = _version;
        }

        value = _fetched;
        return true;
    }
}
