using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// Puts reports together by the picture that they are of. Reports come before their look; those of other vehicles have no look here
/// and are given out after a while as they are.
/// </summary>
internal sealed class LookAssembler(FusionStatistics books)
{
    // So many reports have an identity that is remembered; at most so many wait.
    private const int RememberedReports = 4096;
    private const int MaxGroups = 100;
    private const int MaxReportsPerGroup = 200;

    private readonly List<LookGroup> _groups = [];
    private readonly Stack<LookGroup> _unused = new();
    private readonly SeenReports _seen = new(RememberedReports);

    /// <summary>Whether reports wait.</summary>
    public bool HasWaiting => _groups.Count > 0;

    /// <summary>Takes a report, if it makes sense and is new.</summary>
    public void Add(in TargetReport report, TimeSpan now)
    {
        LookGroup? group = FindOrBegin(report.SourceSystemId, report.PictureNumber, now);
        if (group is not null)
            group.Arrived++;
        if (!ReportCheck.IsSound(report, now))
            books.ReportsRefused++;
        else if (!_seen.Add(new ReportKey(report.SourceSystemId, report.PictureNumber, report.Index)))
            books.ReportsTwice++;
        else if (group is null || group.Reports.Count >= MaxReportsPerGroup)
            books.ReportsWithoutRoom++;
        else
            group.Reports.Add(report);
    }

    /// <summary>Takes out the reports of a look; null when there are none. Give them back after use.</summary>
    public LookGroup? Take(byte source, long look)
    {
        int at = IndexOf(source, look);
        return at < 0 ? null : TakeAt(at);
    }

    /// <summary>Takes out reports that have waited since a time or longer for their look, the oldest first; null when there are none.</summary>
    public LookGroup? TakeWaitingSince(TimeSpan time)
        => _groups.Count > 0 && _groups[0].Since <= time ? TakeAt(0) : null;

    public void GiveBack(LookGroup group) => _unused.Push(group);

    private LookGroup TakeAt(int index)
    {
        LookGroup group = _groups[index];
        _groups.RemoveAt(index);
        return group;
    }

    private LookGroup? FindOrBegin(byte source, long look, TimeSpan now)
    {
        int at = IndexOf(source, look);
        if (at >= 0)
            return _groups[at];
        if (_groups.Count >= MaxGroups)
            return null;
        LookGroup group = _unused.Count > 0 ? _unused.Pop() : new LookGroup();
        group.Begin(source, look, now);
        _groups.Add(group);
        return group;
    }

    private int IndexOf(byte source, long look)
    {
        for (int i = 0; i < _groups.Count; i++)
        {
            if (_groups[i].Source == source && _groups[i].Look == look)
                return i;
        }

        return -1;
    }
}
