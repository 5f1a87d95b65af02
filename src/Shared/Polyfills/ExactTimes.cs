namespace System;

/// <summary>
/// Durations as numbers and back, to the tick and to the bit as .NET has them. Mono rounds what it makes of seconds to
/// a millisecond, and multiplies by 1e-7 where .NET divides by 1e7: one seed would not fly one flight.
/// </summary>
internal static class ExactTimes
{
    extension(TimeSpan)
    {
        /// <summary>That many seconds, less than a tick cut off.</summary>
        /// <exception cref="ArgumentException">It is no number.</exception>
        /// <exception cref="OverflowException">No duration is so long.</exception>
        public static TimeSpan OfSeconds(double seconds) => OfTicks(seconds * TimeSpan.TicksPerSecond);

        /// <summary>That many milliseconds, less than a tick cut off.</summary>
        /// <exception cref="ArgumentException">It is no number.</exception>
        /// <exception cref="OverflowException">No duration is so long.</exception>
        public static TimeSpan OfMilliseconds(double milliseconds)
            => OfTicks(milliseconds * TimeSpan.TicksPerMillisecond);
    }

    extension(TimeSpan time)
    {
        /// <summary>The whole duration in seconds.</summary>
        public double ExactSeconds => (double)time.Ticks / TimeSpan.TicksPerSecond;

        /// <summary>The whole duration in milliseconds.</summary>
        public double ExactMilliseconds => (double)time.Ticks / TimeSpan.TicksPerMillisecond;
    }

    private static TimeSpan OfTicks(double ticks)
    {
        if (double.IsNaN(ticks))
            throw new ArgumentException("A duration is a number.", nameof(ticks));
        const double beyond = -(double)long.MinValue;
        if (ticks > beyond || ticks < -beyond)
            throw new OverflowException("A duration is at most TimeSpan.MaxValue.");
        return ticks < beyond ? TimeSpan.FromTicks((long)ticks) : TimeSpan.MaxValue;
    }
}
