using System;

namespace Rabit.Uav.ImageProcessing;

/// <summary>How long to wait before a camera is opened again: it doubles with each time in vain. One thread.</summary>
internal sealed class RestartDelay
{
    private readonly TimeSpan _first;
    private readonly TimeSpan _max;
    private TimeSpan _next;

    public RestartDelay(TimeSpan first, TimeSpan max) => (_first, _max, _next) = (first, max, first);

    /// <summary>When to try again, by the clock of the run.</summary>
    public TimeSpan Due { get; private set; }

    /// <summary>After a fault.</summary>
    /// <returns>The delay.</returns>
    public TimeSpan Begin(TimeSpan now)
    {
        TimeSpan delay = _next;
        Due = now + delay;
        _next = delay + delay < _max ? delay + delay : _max;
        return delay;
    }

    /// <summary>After a picture.</summary>
    public void Reset() => _next = _first;
}
