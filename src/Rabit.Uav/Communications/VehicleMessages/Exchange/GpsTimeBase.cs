using System;

namespace Rabit.Uav.Communications;

/// <summary>
/// GPS time by the clock of the run, from what the autopilot reports of it, and how good that is. It comes late by the
/// way, never early: of the last reports the earliest one is the best. One thread.
/// </summary>
internal sealed class GpsTimeBase
{
    // SYSTEM_TIME comes about once a second; each period's earliest counts, two periods back.
    private static readonly TimeSpan Period = TimeSpan.FromSeconds(20);
    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(60);

    // Crystals of small computers; and what a report is late at least: serial line, thread, resolution.
    private const double Drift = 50e-6;
    private static readonly TimeSpan MinError = TimeSpan.FromTicks(5 * TimeSpan.TicksPerMillisecond);

    // A clock that was set: the old offset is nothing worth.
    private const long StepMicroseconds = 1_000_000;

    private long? _offset;
    private long? _previous;
    private TimeSpan _periodStart;
    private TimeSpan _newest;

    /// <summary>Takes a report.</summary>
    /// <param name="utcMicroseconds">GPS time, microseconds since 1970 UTC.</param>
    /// <param name="time">When it was true, by the clock of the run.</param>
    public void Note(long utcMicroseconds, TimeSpan time)
    {
        if (utcMicroseconds <= 0 || (_offset is not null && time <= _newest))
            return;
        long offset = utcMicroseconds - Microseconds(time);
        if (_offset is { } known && Math.Abs(offset - known) > StepMicroseconds)
            (_offset, _previous) = (null, null);
        if (_offset is null || time - _periodStart > Period)
            (_previous, _offset, _periodStart) = (_offset, offset, time);
        else
            _offset = Math.Max(_offset.Value, offset);
        _newest = time;
    }

    /// <summary>The time now.</summary>
    /// <param name="now">By the clock of the run.</param>
    /// <param name="lateBy">
    /// What a report is late by at most: half of the round trip to the autopilot; null for not known.
    /// </param>
    /// <param name="utcMicroseconds">GPS time.</param>
    /// <param name="accuracy">How far it may be off.</param>
    /// <returns>False where there is none: no report, or none for a minute.</returns>
    public bool TryGet(TimeSpan now, TimeSpan? lateBy, out long utcMicroseconds, out TimeSpan accuracy)
    {
        (utcMicroseconds, accuracy) = (0, TimeSpan.Zero);
        if (_offset is not { } offset || now - _newest > MaxAge)
            return false;
        long best = _previous is { } previous && previous > offset ? previous : offset;
        utcMicroseconds = Microseconds(now) + best;
        TimeSpan late = lateBy ?? TimeSpan.FromTicks(50 * TimeSpan.TicksPerMillisecond);
        double age = (now - _periodStart + Period).ExactSeconds;
        accuracy = MinError + late + TimeSpan.FromTicks((long)(age * Drift * TimeSpan.TicksPerSecond));
        return true;
    }

    private static long Microseconds(TimeSpan time) => time.Ticks / (TimeSpan.TicksPerMillisecond / 1000);
}
