using System;
using System.Threading;

namespace Rabit.Links;

/// <summary>Ends the waits of opening a link. Any thread; asked once, it stays asked.</summary>
internal sealed class LinkStop
{
    // How soon the wait for a handle sees that it is asked.
    private static readonly TimeSpan Slice = TimeSpan.FromMilliseconds(20);

    private readonly object _gate = new();
    private bool _isRequested; // guarded by _gate

    public bool IsRequested
    {
        get
        {
            lock (_gate) return _isRequested;
        }
    }

    public void Request()
    {
        lock (_gate)
        {
            _isRequested = true;
            Monitor.PulseAll(_gate);
        }
    }

    /// <summary>Waits until it is asked, at most so long; it may return early for no reason.</summary>
    public void Wait(TimeSpan limit)
    {
        lock (_gate)
        {
            if (!_isRequested && limit > TimeSpan.Zero) Monitor.Wait(_gate, limit);
        }
    }

    /// <summary>Waits for a handle, the limit, or until it is asked.</summary>
    /// <returns>False where the handle was not set.</returns>
    public bool WaitFor(WaitHandle handle, TimeSpan limit)
    {
        bool isEndless = limit == Timeout.InfiniteTimeSpan;
        long start = TimeProvider.System.GetTimestamp();
        while (!IsRequested)
        {
            TimeSpan left = isEndless ? Slice : limit - TimeProvider.System.GetElapsedTime(start);
            if (left <= TimeSpan.Zero) return handle.WaitOne(0);
            if (handle.WaitOne(left < Slice ? left : Slice)) return true;
        }

        return false;
    }
}
