using System;

namespace Rabit.Uav.Communications;

/// <summary>How long to wait for an acknowledgement, by those that came (Jacobson 1988, RFC 6298).</summary>
internal sealed class RoundTripTime
{
    // Before the first: a slow radio with all of a message on its way.
    private const double FirstSeconds = 1.5;
    private const double MinSeconds = 0.4;
    private const double MaxSeconds = 4;
    private const double BackOff = 1.5;

    private double _mean;
    private double _deviation;

    public TimeSpan Mean => Seconds(_mean > 0 ? _mean : FirstSeconds);

    public void Note(TimeSpan measured)
    {
        double seconds = measured.ExactSeconds;
        if (_mean == 0)
        {
            (_mean, _deviation) = (seconds, seconds / 2);
            return;
        }

        _deviation += 0.25 * (Math.Abs(seconds - _mean) - _deviation);
        _mean += 0.125 * (seconds - _mean);
    }

    /// <param name="tries">How often it was sent.</param>
    public TimeSpan TimeOut(int tries)
    {
        double first = _mean > 0 ? Math.Max(MinSeconds, _mean + (4 * _deviation)) : FirstSeconds;
        return Seconds(Math.Min(MaxSeconds, first * Math.Pow(BackOff, Math.Min(tries, 8) - 1)));
    }

    // TimeSpan.FromSeconds rounds to milliseconds on Mono.
    private static TimeSpan Seconds(double seconds) => TimeSpan.FromTicks((long)(seconds * TimeSpan.TicksPerSecond));
}
