using System;
using System.Threading;

namespace Rabit.Links;

/// <summary>
/// How much is left of a time-out. A wait may return early, so it is counted against a time, which a garbage collection
/// does not move.
/// </summary>
internal readonly struct Deadline
{
    private readonly long _due; // 0 for never

    /// <param name="timeoutMilliseconds">From now; <see cref="Timeout.Infinite"/> for never.</param>
    public Deadline(int timeoutMilliseconds)
        => _due = timeoutMilliseconds == Timeout.Infinite
            ? 0
            : TimeProvider.System.GetTimestamp()
                + (TimeProvider.System.TimestampFrequency * timeoutMilliseconds / 1000);

    public bool HasPassed => _due != 0 && TimeProvider.System.GetTimestamp() >= _due;

    /// <summary>What to wait for at most: at least 1, or <see cref="Timeout.Infinite"/>.</summary>
    public int Milliseconds
    {
        get
        {
            if (_due == 0) return Timeout.Infinite;
            long left = _due - TimeProvider.System.GetTimestamp();
            return left <= 0 ? 1 : (int)((left * 1000 / TimeProvider.System.TimestampFrequency) + 1);
        }
    }
}
