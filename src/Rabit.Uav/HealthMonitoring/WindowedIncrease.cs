using System;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Whether a counter, which only increases, has increased within a time window.</summary>
internal sealed class WindowedIncrease
{
    private long _last;
    private TimeSpan? _increasedAt;

    /// <summary>Updates it with the present value.</summary>
    /// <returns>Whether it increased within the window before now.</returns>
    public bool Update(long count, TimeSpan now, TimeSpan window)
    {
        if (count > _last)
            _increasedAt = now;
        _last = count;
        return _increasedAt is { } at && now - at < window;
    }
}
