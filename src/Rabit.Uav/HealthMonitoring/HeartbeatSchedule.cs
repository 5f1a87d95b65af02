using System;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// When the next heartbeat and the next look at the rules are due: on a grid that begins with the first unit of work, so that
/// nothing drifts. What was missed is not made up for: a late heartbeat tells of now, not of then.
/// </summary>
internal sealed class HeartbeatSchedule(TimeSpan heartbeatPeriod, TimeSpan cycle)
{
    private TimeSpan? _origin;
    private long _lastBeat = -1;

    /// <summary>Whether a heartbeat is due. True once for each.</summary>
    public bool TakeBeat(TimeSpan now)
    {
        _origin ??= now;
        long beat = (now - _origin.Value).Ticks / heartbeatPeriod.Ticks;
        if (beat <= _lastBeat)
            return false;
        _lastBeat = beat;
        return true;
    }

    /// <summary>How long to sleep until the next look; above zero.</summary>
    public TimeSpan UntilNext(TimeSpan now)
    {
        long sinceLast = (now - (_origin ??= now)).Ticks % cycle.Ticks;
        return new TimeSpan(cycle.Ticks - sinceLast);
    }
}
