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

    /// <summary>How long ago a time was; one that is too long ago for that has the greatest age there is.</summary>
    /// <param name="now">Not negative, as all times of a run.</param>
    /// <param name="time">Any, also one that has not come yet.</param>
    public static TimeSpan Since(TimeSpan now, TimeSpan time)
        => time < TimeSpan.Zero && now > TimeSpan.MaxValue + time ? TimeSpan.MaxValue : now - time;

    public static TimeSpan Earlier(TimeSpan a, TimeSpan b) => a < b ? a : b;
}
