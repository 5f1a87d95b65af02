using System;

namespace Rabit.Uav.Communications;

/// <summary>
/// The part of its rate that a link may use, by how long frames take there and back: what that is above the shortest of
/// the last minutes is time in queues (as TCP Vegas, Brakmo 1994, and LEDBAT, RFC 6817, have it). Steps as of PX4's law
/// of the radio's buffer. One thread.
/// </summary>
internal sealed class RoundTripLaw
{
    private const double Least = 0.05;
    private const double Less = 0.8;
    private const double More = 1.025;

    // Two of the longest frames at 3600 bytes a second wait as long.
    private static readonly TimeSpan MaxQueueing = TimeSpan.FromTicks(150 * TimeSpan.TicksPerMillisecond);
    private static readonly TimeSpan LittleQueueing = TimeSpan.FromTicks(75 * TimeSpan.TicksPerMillisecond);

    // The way may have become longer for good: the shortest of this period and the one before counts.
    private static readonly TimeSpan Period = TimeSpan.FromMinutes(2);

    // Without answers nothing is known.
    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(10);

    private TimeSpan _shortest = TimeSpan.MaxValue;
    private TimeSpan _previousShortest = TimeSpan.MaxValue;
    private TimeSpan _periodStart;
    private TimeSpan _newest;
    private double _factor = 1;

    /// <summary>The last measured one; zero before the first.</summary>
    public TimeSpan RoundTrip { get; private set; }

    public double FactorAt(TimeSpan now)
    {
        if (now - _newest > MaxAge)
            _factor = 1;
        return _factor;
    }

    public void Note(TimeSpan roundTrip, TimeSpan now)
    {
        if (now - _periodStart > Period)
            (_previousShortest, _shortest, _periodStart) = (_shortest, TimeSpan.MaxValue, now);
        if (roundTrip < _shortest)
            _shortest = roundTrip;
        (RoundTrip, _newest) = (roundTrip, now);
        TimeSpan queueing = roundTrip - (_previousShortest < _shortest ? _previousShortest : _shortest);
        double change = queueing > MaxQueueing ? Less : queueing < LittleQueueing ? More : 1;
        _factor = Math.Min(1, Math.Max(Least, _factor * change));
    }
}
