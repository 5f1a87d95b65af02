using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Where another vehicle of the group is, and how it moves, by its last reports. One thread.</summary>
internal sealed class GroupTraffic
{
    // A report a second: the velocity is that of two seconds or more, for positions are off by some decimetres.
    private const int MaxKept = 3;
    private const double MinBaseSeconds = 0.5;

    // A vehicle of a group does not fly faster; a position that jumps does.
    private const double MaxMetresPerSecond = 30;

    private readonly Queue<(GeodeticPosition Position, TimeSpan Time)> _kept = new();

    /// <summary>The last report.</summary>
    public GroupReport Report { get; private set; }

    /// <summary>Of when that is.</summary>
    public TimeSpan Time { get; private set; } = TimeSpan.MinValue;

    /// <summary>Metres per second.</summary>
    public NedVector Velocity { get; private set; }

    /// <summary>Takes a report; one that is older than the last changes nothing.</summary>
    public void Take(in GroupReport report, TimeSpan time)
    {
        if (time < Time)
            return;
        bool isNewer = time > Time;
        (Report, Time) = (report, time);
        if (!isNewer)
            return;
        if (_kept.Count == MaxKept)
            _kept.Dequeue();
        _kept.Enqueue((report.Position, time));
        (GeodeticPosition earlier, TimeSpan then) = _kept.Peek();
        double seconds = (time - then).ExactSeconds;
        if (seconds < MinBaseSeconds)
            return;
        NedPosition moved = LocalNedFrame.IgnoringGeoid(earlier).ToNed(report.Position);
        var velocity = new NedVector(moved.North / seconds, moved.East / seconds, moved.Down / seconds);
        Velocity = velocity.Length <= MaxMetresPerSecond ? velocity : default;
    }
}
