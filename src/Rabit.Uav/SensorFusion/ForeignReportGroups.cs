using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// Groups the reports of other vehicles by picture: each travels in a message of its own, and all of a picture are to
/// be assigned to tracks at once. A group is given out some time after its first report. For one thread.
/// </summary>
internal sealed class ForeignReportGroups(FusionStatistics statistics)
{
    private const int MaxGroups = 100;
    private const int MaxReportsPerGroup = 200;

    private readonly List<ReportGroup> _groups = [];
    private readonly Stack<ReportGroup> _unused = new();

    /// <summary>Whether reports wait.</summary>
    public bool HasWaiting => _groups.Count > 0;

    /// <summary>Takes a report, valid and new; counts it if there is no room.</summary>
    public void Add(in TargetReport report, TimeSpan now)
    {
        ReportGroup? group = FindOrBegin(report.SourceSystemId, report.PictureNumber, now);
        if (group is null || group.Reports.Count >= MaxReportsPerGroup)
            statistics.ReportsWithoutRoom++;
        else
            group.Reports.Add(report);
    }

    /// <summary>
    /// Takes out a group that began at a time or before, the oldest first; null when there is none. Give it back after
    /// use.
    /// </summary>
    public ReportGroup? TakeSince(TimeSpan time)
    {
        if (_groups.Count == 0 || _groups[0].Since > time)
            return null;
        ReportGroup group = _groups[0];
        _groups.RemoveAt(0);
        return group;
    }

    public void GiveBack(ReportGroup group) => _unused.Push(group);

    private ReportGroup? FindOrBegin(byte source, long picture, TimeSpan now)
    {
        foreach (ReportGroup waiting in _groups)
        {
            if (waiting.Source == source && waiting.Picture == picture)
                return waiting;
        }

        if (_groups.Count >= MaxGroups)
            return null;
        ReportGroup group = _unused.Count > 0 ? _unused.Pop() : new ReportGroup();
        group.Begin(source, picture, now);
        _groups.Add(group);
        return group;
    }
}
