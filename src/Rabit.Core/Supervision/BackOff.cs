using System;

namespace Rabit.Core.Supervision;

/// <summary>Delays that double.</summary>
internal static class BackOff
{
    /// <summary>The delay after so many others in a row.</summary>
    public static TimeSpan Delay(TimeSpan first, TimeSpan longest, long count)
    {
        TimeSpan delay = first;
        for (long i = 0; i < count && delay < longest; i++)
            delay = delay.Ticks > longest.Ticks / 2 ? longest : delay + delay;
        return delay;
    }

    /// <exception cref="ArgumentOutOfRangeException">A delay is out of its range.</exception>
    public static void Check(TimeSpan firstDelay, TimeSpan maxDelay, string what)
    {
        Require.Positive(firstDelay, nameof(firstDelay), $"The delay {what}");
        if (maxDelay < firstDelay)
            throw new ArgumentOutOfRangeException(
                nameof(maxDelay), maxDelay, $"The longest delay {what} cannot be below the first.");
    }
}
