using System;

namespace Rabit.Uav.Communications;

/// <summary>
/// When a growing number of dropped frames is logged: on the first change, then at most every 10 s, with the total.
/// Used by the manager's thread.
/// </summary>
internal sealed class DropReport
{
    // A queue that stays full drops for as long as the run: a line every 10 s shows that it still does.
    private static readonly TimeSpan Period = TimeSpan.FromSeconds(10);

    private long _reported;
    private TimeSpan? _last;

    /// <param name="total">How many were dropped so far.</param>
    /// <param name="now">The manager's time.</param>
    /// <param name="isEnd">Whether no later report will come: then a change is reported at once.</param>
    /// <returns>Whether to log <paramref name="total"/> now.</returns>
    public bool IsDue(long total, TimeSpan now, bool isEnd)
    {
        if (total <= _reported || (!isEnd && now - _last < Period))
            return false;
        (_reported, _last) = (total, now);
        return true;
    }
}
