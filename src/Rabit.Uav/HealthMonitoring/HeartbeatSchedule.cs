using System;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// When the next heartbeat and the next evaluation of the rules are due: on a grid that begins with the first unit of
/// work, so that nothing drifts. Missed heartbeats are not sent later: each reports the present.
/// </summary>
internal sealed class HeartbeatSchedule(TimeSpan heartbeatPeriod, TimeSpan evaluationPeriod)
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

    /// <summary>How long to sleep until the next evaluation; above zero.</summary>
    public TimeSpan UntilNext(TimeSpan now)
    {
        long sinceLast = (now - (_origin ??= now)).Ticks % evaluationPeriod.Ticks;
        return new TimeSpan(evaluationPeriod.Ticks - sinceLast);
    }
}
