using System;

namespace Rabit.Core;

/// <summary>What happens after an exception left a manager's code. It is in the log, the status and the result under every policy. Immutable.</summary>
public sealed class FaultPolicy
{
    private FaultPolicy(bool stopsSystem, TimeSpan firstDelay, TimeSpan longestDelay)
    {
        StopsSystem = stopsSystem;
        FirstDelay = firstDelay;
        LongestDelay = longestDelay;
    }

    /// <summary>The default: all managers are stopped in order, and the run ends with exit code 1.</summary>
    public static FaultPolicy StopSystem { get; } = new(stopsSystem: true, TimeSpan.Zero, TimeSpan.Zero);

    /// <summary>
    /// The manager carries on after a delay of 10 ms that doubles with every further fault, up to 1 s, and starts anew
    /// after a unit of work without a fault. Wake-ups that come during the delay are kept.
    /// </summary>
    public static FaultPolicy CarryOn { get; } = CarryOnAfter(TimeSpan.FromMilliseconds(10), TimeSpan.FromSeconds(1));

    /// <summary>Whether a fault stops the whole system.</summary>
    public bool StopsSystem { get; }

    /// <summary>The delay after the first of several faults.</summary>
    public TimeSpan FirstDelay { get; }

    /// <summary>The longest delay.</summary>
    public TimeSpan LongestDelay { get; }

    /// <summary>As <see cref="CarryOn"/>, with other delays.</summary>
    /// <param name="firstDelay">After the first fault; longer than zero, or a manager that always throws would take a whole core.</param>
    /// <param name="longestDelay">Where the doubling ends; not below the first.</param>
    /// <exception cref="ArgumentOutOfRangeException">A delay is out of its range.</exception>
    public static FaultPolicy CarryOnAfter(TimeSpan firstDelay, TimeSpan longestDelay)
    {
        Require.Positive(firstDelay, nameof(firstDelay), "The delay after a fault");
        if (longestDelay < firstDelay)
            throw new ArgumentOutOfRangeException(nameof(longestDelay), longestDelay, "The longest delay cannot be below the first.");
        return new FaultPolicy(stopsSystem: false, firstDelay, longestDelay);
    }

    internal TimeSpan DelayAfter(TimeSpan lastDelay)
    {
        if (lastDelay == TimeSpan.Zero)
            return FirstDelay;
        long doubled = Math.Min(lastDelay.Ticks, long.MaxValue / 2) * 2;
        return new TimeSpan(Math.Min(doubled, LongestDelay.Ticks));
    }
}
