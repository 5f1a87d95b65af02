using System;

namespace Rabit.Core.Time;

/// <summary>Holds virtual time back to a multiple of real time, and measures what steps take in real time.</summary>
internal sealed class Pacer(VirtualTime time)
{
    private readonly TimeProvider _real = TimeProvider.System;
    private long _startCount;
    private TimeSpan _startVirtual;
    private bool _started;

    public bool IsUnlimited => double.IsPositiveInfinity(time.Pace);

    /// <summary>The virtual time that should be now; the first call starts the pacing.</summary>
    public TimeSpan Now(TimeSpan virtualNow)
    {
        if (!_started)
        {
            _startCount = _real.GetTimestamp();
            _startVirtual = virtualNow;
            _started = true;
        }

        return _startVirtual + new TimeSpan((long)(_real.GetElapsedTime(_startCount).Ticks * time.Pace));
    }

    /// <summary>Real time until a virtual time comes.</summary>
    public TimeSpan Until(TimeSpan virtualDue, TimeSpan virtualNow)
        => new((long)((virtualDue - virtualNow).Ticks / time.Pace));

    public long Mark() => _real.GetTimestamp();

    public TimeSpan Since(long mark) => _real.GetElapsedTime(mark);
}
