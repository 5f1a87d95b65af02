using System.Diagnostics;

namespace Rabit.Benchmarks.Core;

/// <summary>The latest value under a lock, the baseline.</summary>
internal sealed class MonitorMessage<T>
{
    private readonly object _gate = new();
    private T _value = default!;
    private long _time;
    private long _version;

    public void Post(in T value)
    {
        lock (_gate)
        {
            _value = value;
            _version++;
        }
    }

    public void PostWithTime(in T value)
    {
        long now = Stopwatch.GetTimestamp();
        lock (_gate)
        {
            _value = value;
            _time = now;
            _version++;
        }
    }

    public bool Fetch(ref T value, ref long seen)
    {
        lock (_gate)
        {
            if (_version == seen)
                return false;
            value = _value;
            seen = _version;
            return true;
        }
    }
}
