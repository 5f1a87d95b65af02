using System;

namespace Rabit.Core.Managers;

/// <summary>A unit of work with a modelled duration, as far as its figures depend on when it really ends.</summary>
/// <param name="begin">When it began.</param>
/// <param name="end">When it ends, unless the run ends before.</param>
/// <param name="wokenAt">What ended the sleep before it.</param>
/// <param name="deadline">That of its period, if it ran for one.</param>
/// <param name="grid">The deadlines, before they were set for the next unit of work.</param>
/// <param name="period">The period that holds; null for none.</param>
/// <param name="missed">The deadlines that will have passed at its end.</param>
/// <param name="isToBeCounted">Whether its figures wait for its end: it hangs, and may never come to it.</param>
internal readonly struct ModelledRun(
    TimeSpan begin, TimeSpan end, TimeSpan? wokenAt, TimeSpan? deadline, PeriodGrid grid, TimeSpan? period, long missed,
    bool isToBeCounted)
{
    public TimeSpan Begin => begin;

    public TimeSpan End => end;

    public TimeSpan? WokenAt => wokenAt;

    public TimeSpan? Deadline => deadline;

    public bool IsToBeCounted => isToBeCounted;

    /// <summary>What the status holds of its missed deadlines.</summary>
    public long MissedSoFar => isToBeCounted ? 0 : missed;

    /// <summary>The deadlines that have passed at a time that is not after its end.</summary>
    public long MissedUntil(TimeSpan time)
    {
        if (time >= end)
            return missed;
        if (period is not { } length)
            return 0;
        PeriodGrid deadlines = grid;
        deadlines.Next(length, begin, time, out long passed);
        return passed;
    }
}
