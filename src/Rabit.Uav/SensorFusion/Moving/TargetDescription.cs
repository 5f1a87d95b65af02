using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>What is known of the target of a track beside where it is.</summary>
internal sealed class TargetDescription
{
    private double _sizeSum;
    private int _sizes;
    private double _bestScore;

    /// <summary>Mean of the reports, metres.</summary>
    public double SizeMetres => _sizes == 0 ? 0 : _sizeSum / _sizes;

    /// <summary>Of the ground that it stands on, metres below the origin, as the newest report says.</summary>
    public double Down { get; private set; }

    public long BestPictureNumber { get; private set; }

    public int BestReportIndex { get; private set; }

    /// <summary>When a report of it last went out to others; null before the first.</summary>
    public TimeSpan? SharedTime { get; set; }

    /// <summary>What the operator said about it.</summary>
    public TargetDecision Decision { get; set; }

    public void Clear()
    {
        (_sizeSum, _sizes, _bestScore) = (0, 0, double.NegativeInfinity);
        (Down, BestPictureNumber, BestReportIndex) = (0, -1, 0);
        (SharedTime, Decision) = (null, TargetDecision.None);
    }

    public void Add(in LocatedReport report)
    {
        Down = report.Down;
        _sizeSum += report.Report.SizeMetres;
        _sizes++;

        // Only pictures of our own can be shown.
        if (report.IsOwn && report.Report.Score > _bestScore)
            (_bestScore, BestPictureNumber, BestReportIndex) =
                (report.Report.Score, report.Report.PictureNumber, report.Report.Index);
    }
}
