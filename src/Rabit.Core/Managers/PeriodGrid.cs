using System;
using Rabit.Core.Time;

namespace Rabit.Core.Managers;

/// <summary>
/// The deadlines of a fixed period: absolute, so that no lateness adds up. Times are those of the run's clock.
/// </summary>
internal struct PeriodGrid
{
    private TimeSpan _period;
    private TimeSpan _deadline;

    /// <summary>Says when the next unit of work is due.</summary>
    /// <param name="period">The period that holds now; another one than before begins a new grid.</param>
    /// <param name="begin">When the last unit of work began.</param>
    /// <param name="end">When it ended.</param>
    /// <param name="missedDeadlines">
    /// Deadlines that passed, since the last call, before their unit of work could begin.
    /// </param>
    public TimeSpan Next(TimeSpan period, TimeSpan begin, TimeSpan end, out long missedDeadlines)
    {
        missedDeadlines = 0;
        if (period != _period)
        {
            _period = period;
            _deadline = Times.Later(begin, period);
        }
        else if (_deadline <= begin)
        {
            // The last run was for the newest deadline before it; older ones had none.
            long missed = (begin - _deadline).Ticks / period.Ticks;
            missedDeadlines += missed;
            _deadline = Times.Later(_deadline, new TimeSpan(period.Ticks * (missed + 1)));
        }

        if (_deadline <= end)
        {
            // The newest of those that passed meanwhile is run for at once, and is late.
            long passed = (end - _deadline).Ticks / period.Ticks;
            missedDeadlines += passed + 1;
            _deadline += new TimeSpan(period.Ticks * passed);
        }

        return _deadline;
    }
}
