using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Finds out that another commander sends PX4 elsewhere while we hold in AUTO.LOITER: a DO_REPOSITION changes no mode
/// there, and POSITION_TARGET_GLOBAL_INT reports another place. No I/O, one thread.
/// </summary>
/// <remarks>
/// PX4 1.14 reports the place where it holds within 25 ms of the mode, and the same to the digit until the mode ends
/// (11 holds in the recordings). A failsafe changes the place 0.1 to 0.7 s before a heartbeat shows its mode, so that a
/// report of AUTO.LOITER has to follow.
/// </remarks>
internal sealed class HoldTargetMonitor
{
    // The place of the hold is reported from the next sample on; in a take-off the one before is reported until then.
    private static readonly TimeSpan SettlingTime = TimeSpan.OfSeconds(0.6);

    private const double MaxShiftMetres = 2;

    private TimeSpan? _watchedSince;
    private GeodeticPosition? _place;

    /// <summary>When another place was reported; null where none was.</summary>
    public TimeSpan? ForeignSince { get; private set; }

    /// <summary>Our hold has begun.</summary>
    public void Begin(TimeSpan time)
    {
        Stop();
        _watchedSince = time + SettlingTime;
    }

    public void Stop() => (_watchedSince, _place, ForeignSince) = (null, null, null);

    /// <summary>Takes the place that the autopilot flies to.</summary>
    public void TakeReport(in PositionTargetGlobalInt report, TimeSpan time)
    {
        if (_watchedSince is not { } since || time < since)
            return;
        GeodeticPosition reported = GeodeticPosition.FromDegrees(report.LatInt / 1e7, report.LonInt / 1e7, report.Alt);
        GeodeticPosition place = _place ??= reported;
        NedPosition shift = LocalNedFrame.IgnoringGeoid(place).ToNed(reported);
        if ((shift - NedPosition.Origin).Length > MaxShiftMetres)
            ForeignSince ??= time;
    }
}
