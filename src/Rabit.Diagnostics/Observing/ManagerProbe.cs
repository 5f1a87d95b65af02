using System;
using Rabit.Core;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Diagnostics.Observing;

/// <summary>Reads the status of one manager, as any subscriber outside managers does.</summary>
internal sealed class ManagerProbe(RabitReactor reactor, string name)
{
    private readonly MessageSubscriber<ManagerStatus> _status = reactor.Workspace.SubscribeToStatus(name);
    private long _lastRuns;
    private TimeSpan _lastBusy;

    public ManagerFigures Read(Elapsed? elapsed)
    {
        _status.Fetch();
        ManagerStatus status = _status.Value;
        TimeSpan busy = Busy(status, out bool isMeasured);
        long runs = status.Runs - _lastRuns;
        TimeSpan worked = busy - _lastBusy;
        if (runs < 0 || worked < TimeSpan.Zero)
            (runs, worked) = (status.Runs, busy);   // the figures were reset
        (_lastRuns, _lastBusy) = (status.Runs, busy);
        return new ManagerFigures
        {
            Name = name,
            State = status.State.ToString().ToLowerInvariant(),
            Runs = status.Runs,
            RunsPerSecond = elapsed?.Rate(runs),
            Load = isMeasured ? elapsed?.PartOfReal(worked) : null,
            WakeUps = WakeUpsOf(status.WakeUps),
            UnitOfWork = TimesOf(status.UnitOfWorkTime),
            WakeLatency = TimesOf(status.WakeLatency),
            PeriodError = TimesOf(status.PeriodError),
            MissedDeadlines = status.MissedDeadlines,
            LateUnitsOfWork = status.LateUnitsOfWork,
            Faults = status.Faults,
            LastFault = status.LastFault,
            Restarts = status.Restarts,
            Hangs = status.Hangs,
            LastHang = status.LastHang,
        };
    }

    // In virtual time the status holds virtual durations; what the steps really took is measured beside them.
    private TimeSpan Busy(in ManagerStatus status, out bool isMeasured)
    {
        DurationStatistics steps = reactor.RealStepTime(name);
        DurationStatistics times = steps.Count > 0 ? steps : status.UnitOfWorkTime;
        isMeasured = times.Count > 0;
        return times.Total;
    }

    private static WakeUpFigures WakeUpsOf(in WakeUpStatistics counts) => new()
    {
        Timer = counts.Timer,
        Post = counts.Post,
        Push = counts.Push,
        Pop = counts.Pop,
        Request = counts.Request,
        Device = counts.Device,
        Merged = counts.Merged,
    };

    private static TimesFigures TimesOf(in DurationStatistics times) => times.Count == 0
        ? new TimesFigures()
        : new TimesFigures
        {
            P50Seconds = times.Percentile50.TotalSeconds,
            P99Seconds = times.Percentile99.TotalSeconds,
            MaxSeconds = times.Max.TotalSeconds,
        };
}
