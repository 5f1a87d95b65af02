using System;
using System.Collections.Immutable;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>What is known of the target of a track beside where it is.</summary>
internal sealed class TargetDescription
{
    private double _sizeSum;
    private int _sizes;
    private BestReports _best;

    /// <summary>Mean of the reports, metres.</summary>
    public double SizeMetres => _sizes == 0 ? 0 : _sizeSum / _sizes;

    /// <summary>As the newest report says: it turns.</summary>
    public TargetBearing? Bearing { get; private set; }

    /// <summary>Of the ground that it stands on, metres below the origin, as the newest report says.</summary>
    public double Down { get; private set; }

    public long BestPictureNumber => _best.PictureNumber;

    public int BestReportIndex => _best.ReportIndex;

    public ImmutableArray<TrackPicture> OtherPictures => _best.Others;

    /// <summary>When a report of it last went out to others; null before the first.</summary>
    public TimeSpan? SharedTime { get; set; }

    /// <summary>What the operator said about it.</summary>
    public TargetDecision Decision { get; set; }

    /// <summary>The picture of its last report of our own; negative before one.</summary>
    public long LastOwnPicture { get; private set; }

    public void Clear(double down = 0)
    {
        (_sizeSum, _sizes, _best) = (0, 0, default);
        (Down, Bearing, LastOwnPicture) = (down, null, -1);
        (SharedTime, Decision) = (null, TargetDecision.None);
    }

    /// <summary>Adds what is known of the same target since.</summary>
    public void GoOnAs(TargetDescription later)
    {
        (_sizeSum, _sizes) = (_sizeSum + later._sizeSum, _sizes + later._sizes);
        (Down, Bearing) = (later.Down, later.Bearing);
        LastOwnPicture = Math.Max(LastOwnPicture, later.LastOwnPicture);
        SharedTime = later.SharedTime ?? SharedTime;
        if (later.Decision != TargetDecision.None)
            Decision = later.Decision;
    }

    public void Add(in LocatedReport report)
    {
        Down = report.Down;
        Bearing = report.Report.Bearing;
        _sizeSum += report.Report.SizeMetres;
        _sizes++;

        // Only pictures of our own can be shown.
        if (!report.IsOwn)
            return;
        LastOwnPicture = report.Report.PictureNumber;
        _best.Add(report.Report.Score, new TrackPicture(report.Report.PictureNumber, report.Report.Index));
    }
}
