using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The closed way of a target that moves, again and again: an exact function of the time, so that every camera sees
/// the same and the truth of any moment can be asked for. Immutable.
/// </summary>
internal sealed class TargetRoute
{
    private readonly RouteLeg[] _legs;
    private readonly double _period;

    public TargetRoute(IEnumerable<RouteLeg> legs)
    {
        _legs = legs.ToArray();
        _period = _legs.Sum(l => l.Seconds);
    }

    /// <summary>How long it takes once.</summary>
    public double PeriodSeconds => _period;

    public NedPosition PositionAt(TimeSpan time)
    {
        RouteLeg leg = LegAt(time, out double seconds);
        return leg.PositionAt(seconds);
    }

    public NedVector VelocityAt(TimeSpan time)
    {
        RouteLeg leg = LegAt(time, out double seconds);
        return leg.VelocityAt(seconds);
    }

    // A time before the start of the run is that of the start.
    private RouteLeg LegAt(TimeSpan time, out double seconds)
    {
        seconds = Math.Max(0, time.ExactSeconds) % _period;
        foreach (RouteLeg leg in _legs)
        {
            if (seconds < leg.Seconds)
                return leg;
            seconds -= leg.Seconds;
        }

        seconds = _legs[_legs.Length - 1].Seconds;
        return _legs[_legs.Length - 1];
    }
}
