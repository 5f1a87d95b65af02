namespace Rabit.Core;

/// <summary>
/// How many units of work each cause woke. A unit of work with two causes counts for both. A plain value.
/// </summary>
public struct WakeUpStatistics
{
    /// <summary>Units of work that a timer caused.</summary>
    public long Timer { get; private set; }

    /// <summary>Units of work that a post caused.</summary>
    public long Post { get; private set; }

    /// <summary>Units of work that a push caused.</summary>
    public long Push { get; private set; }

    /// <summary>Units of work that a pop caused.</summary>
    public long Pop { get; private set; }

    /// <summary>Units of work that a call of <see cref="RabitManager.WakeUp"/> caused.</summary>
    public long Request { get; private set; }

    /// <summary>Units of work that a reader or writer of the manager caused.</summary>
    public long Device { get; private set; }

    /// <summary>
    /// Wake-ups that found another one waiting and merged with it: they did not stack. A push or pop that finds one of
    /// its kind waiting makes no wake-up, and does not count here; the counters of the queue have it.
    /// </summary>
    public long Merged { get; private set; }

    internal void Count(WakeUpCauses causes, int wakes)
    {
        if ((causes & WakeUpCauses.Timer) != 0)
            Timer++;
        if ((causes & WakeUpCauses.Post) != 0)
            Post++;
        if ((causes & WakeUpCauses.Push) != 0)
            Push++;
        if ((causes & WakeUpCauses.Pop) != 0)
            Pop++;
        if ((causes & WakeUpCauses.Request) != 0)
            Request++;
        if ((causes & WakeUpCauses.Device) != 0)
            Device++;
        if (wakes > 1)
            Merged += wakes - 1;
    }
}
