using System;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Says of a count that only rises whether it rose lately.</summary>
internal sealed class WindowedIncrease
{
    private long _last;
    private TimeSpan? _roseAt;

    /// <summary>Takes the count as it is now.</summary>
    /// <returns>Whether it rose within the time before now.</returns>
    public bool Take(long count, TimeSpan now, TimeSpan within)
    {
        if (count > _last)
            _roseAt = now;
        _last = count;
        return _roseAt is { } at && now - at < within;
    }
}
