using System;
using System.Collections.Generic;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// How much way and time revisits may take. A detour counts from where the vehicle leaves the search to where it goes
/// on, less the way between the two.
/// </summary>
internal sealed class RevisitBudget
{
    // The pass over the target and the time over it, with what starting and stopping takes.
    private static readonly TimeSpan TimeOfRevisit = TimeSpan.FromSeconds(30);

    private readonly double _speed;
    private TimeSpan _time;
    private int _count;

    public RevisitBudget(MissionPlan mission, IReadOnlyList<LaneSegment> lanes)
    {
        double lanesWay = 0;
        for (int i = 0; i < lanes.Count; i++)
            lanesWay += lanes[i].Length + (i == 0 ? 0 : lanes[i - 1].End.DistanceTo(lanes[i].Start));
        LimitMetres = mission.Revisit.MaxWayFraction * lanesWay;
        _speed = mission.SpeedMetresPerSecond;
    }

    /// <summary>How much way there is for all of them.</summary>
    public double LimitMetres { get; }

    /// <summary>How much of it is used.</summary>
    public double UsedMetres { get; private set; }

    /// <summary>Why there is no way or time for one more, as text; null where there is.</summary>
    /// <param name="detourMetres">What it takes.</param>
    public string? FindFault(double detourMetres)
    {
        TimeSpan limit = TimeSpan.OfSeconds(LimitMetres / _speed) + TimeSpan.FromTicks(TimeOfRevisit.Ticks * _count);
        return UsedMetres + detourMetres > LimitMetres
            ? $"would take {MissionNumbers.Of(detourMetres)} m more; of the {MissionNumbers.Of(LimitMetres)} m for "
                + $"revisits {MissionNumbers.Of(UsedMetres)} m are used"
            : _time > limit
                ? $"would take more time; revisits have taken {MissionNumbers.Seconds(_time)} of "
                    + MissionNumbers.Seconds(limit)
            : null;
    }

    /// <summary>Takes the way of one.</summary>
    public void TakeWay(double detourMetres)
    {
        UsedMetres += detourMetres;
        _count++;
    }

    /// <summary>Takes the time that one took.</summary>
    public void TakeTime(TimeSpan time) => _time += time;
}
