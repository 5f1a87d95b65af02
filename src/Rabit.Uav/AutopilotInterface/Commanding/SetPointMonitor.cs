using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Finds out that another commander streams set-points to PX4 in OFFBOARD: PX4 flies to the newest of any sender
/// and reports it in POSITION_TARGET_LOCAL_NED. No I/O, one thread.
/// </summary>
/// <remarks>
/// In OFFBOARD that message has the place of the set-point that is flown to: in the 12 recordings of PX4 1.14 with
/// OFFBOARD all 1454 reports of a place are set-points that were sent within the 2 s before, 1.6 m off at most. The
/// origin of the frame is not asked for: the first report shows how far it is from ours, and each that fits follows the
/// scale of PX4's projection. Of two commanders both are reported in turn: one that is none of ours, ours again, and
/// another that is none. So neither a mode that has changed nor a frame that has another origin is taken for a
/// commander; a report of OFFBOARD has to follow besides.
/// </remarks>
internal sealed class SetPointMonitor
{
    // Of 20 Hz: what may be flown to and reported with the delay of a link.
    private const int MaxSent = 40;

    // The worst of the recordings, and half a set-point's way at 8 m/s and 20 Hz.
    private const double MaxShiftMetres = 2.5;

    // PX4's projection differs from WGS84 by 0.5 % at most: 0.1 m between two reports at 10 Hz and 20 m/s.
    private const double Following = 0.2;

    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(2);

    // In this time a commander of 10 Hz beside ours of 20 Hz is reported several times; one stray report is forgotten.
    private static readonly TimeSpan MaxGap = TimeSpan.FromSeconds(3);

    private readonly (TimeSpan Time, NedPosition Place)[] _sent = new (TimeSpan, NedPosition)[MaxSent];
    private LocalNedFrame? _frame;
    private NedVector? _offset;
    private int _count;
    private TimeSpan? _foreignAt;
    private bool _isOursAgain;

    /// <summary>When the report came that showed another commander; null where none did.</summary>
    public TimeSpan? ForeignSince { get; private set; }

    /// <summary>The frame of the autopilot may be another, or the stream begins again.</summary>
    public void Restart() => (_frame, _offset, _count, _foreignAt, ForeignSince) = (null, null, 0, null, null);

    /// <summary>A set-point is sent.</summary>
    /// <param name="place">Where; its altitude is not used.</param>
    /// <param name="heightMetres">The height above home.</param>
    /// <param name="time">When.</param>
    public void TakeSent(in GeodeticPosition place, double heightMetres, TimeSpan time)
    {
        LocalNedFrame frame = _frame ??= LocalNedFrame.IgnoringGeoid(place);
        NedPosition at = frame.ToNed(place);
        _sent[_count++ % MaxSent] = (time, new NedPosition(at.North, at.East, -heightMetres));
    }

    /// <summary>Takes the set-point that the autopilot reports in OFFBOARD.</summary>
    public void TakeReport(in PositionTargetLocalNed report, TimeSpan time)
    {
        // Not a number: PX4 does not fly to a place now, for want of a position, or to a velocity of another.
        var reported = new NedPosition(report.X, report.Y, report.Z);
        if (_count == 0 || double.IsNaN(reported.North + reported.East + reported.Down))
            return;
        NedVector offset = _offset ??= reported - _sent[(_count - 1) % MaxSent].Place;
        NedVector rest = FindNearest(reported - offset, time);
        if (rest.Length <= MaxShiftMetres)
        {
            _offset = offset + (rest * Following);
            _isOursAgain = true;
            return;
        }

        if (_isOursAgain && time - _foreignAt <= MaxGap)
            ForeignSince ??= time;
        (_foreignAt, _isOursAgain) = (time, false);
    }

    private NedVector FindNearest(NedPosition reported, TimeSpan time)
    {
        var nearest = new NedVector(double.MaxValue, 0, 0);
        for (int i = 0; i < Math.Min(_count, MaxSent); i++)
        {
            NedVector rest = reported - _sent[i].Place;
            if (time - _sent[i].Time <= MaxAge && rest.Length < nearest.Length)
                nearest = rest;
        }

        return nearest;
    }
}
