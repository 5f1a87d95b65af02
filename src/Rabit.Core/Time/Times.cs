using System;

namespace Rabit.Core.Time;

/// <summary>Sums of times that may be "never".</summary>
internal static class Times
{
    public static TimeSpan Later(TimeSpan time, TimeSpan delay)
        => time > TimeSpan.MaxValue - delay ? TimeSpan.MaxValue : time + delay;

    public static TimeSpan Earlier(TimeSpan a, TimeSpan b) => a < b ? a : b;
}
