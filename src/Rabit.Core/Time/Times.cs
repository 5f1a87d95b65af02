using System;

namespace Rabit.Core.Time;

/// <summary>Sums of times that may be "never".</summary>
internal static class Times
{
    /// <param name="time">From when.</param>
    /// <param name="delay"><see cref="System.Threading.Timeout.InfiniteTimeSpan"/> for never.</param>
    public static TimeSpan LaterOrNever(TimeSpan time, TimeSpan delay)
        => delay == System.Threading.Timeout.InfiniteTimeSpan ? TimeSpan.MaxValue : Later(time, delay);

    public static TimeSpan Later(TimeSpan time, TimeSpan delay)
        => time > TimeSpan.MaxValue - delay ? TimeSpan.MaxValue : time + delay;

    public static TimeSpan Earlier(TimeSpan a, TimeSpan b) => a < b ? a : b;
}
