using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Web.Collecting;

namespace Rabit.Uav.Web.State;

/// <summary>
/// The managers: state, runs per second of flight, part of a core in real time, how late they wake, what they missed.
/// </summary>
/// <param name="prefix">Of the vehicle.</param>
/// <param name="names">The managers, in the order of their moments.</param>
/// <param name="realTimeOf">
/// How long a manager's units of work took in real time, where the run is in virtual time.
/// </param>
internal sealed class ManagerItems(
    string prefix, IReadOnlyList<string> names, Func<string, DurationStatistics> realTimeOf)
{
    private const int MaxManagers = 64;

    private static readonly TimeSpan Window = TimeSpan.FromSeconds(2);

    private readonly Figures[] _figures = [.. names.Take(MaxManagers).Select(_ => new Figures())];
    private IReadOnlyList<ManagerMoment>? _last;

    /// <param name="writer">Takes the values.</param>
    /// <param name="moment">What the managers posted.</param>
    /// <param name="realTime">Real time since the page started.</param>
    public void Write(ItemWriter writer, FlightMoment moment, TimeSpan realTime)
    {
        if (ReferenceEquals(moment.Managers, _last) || moment.Managers.Count == 0)
            return;
        _last = moment.Managers;
        for (int manager = 0; manager < _figures.Length; manager++)
        {
            ManagerMoment posted = _last[manager];
            DurationStatistics real = realTimeOf(names[manager]);
            DurationStatistics work = real.Count > 0 ? real : posted.Status.UnitOfWorkTime;
            _figures[manager].Take(posted, work, realTime);
            Write(writer, manager, posted.Status, work);
        }
    }

    private void Write(ItemWriter writer, int manager, in ManagerStatus status, in DurationStatistics work)
    {
        DurationStatistics wake = status.WakeLatency;
        writer.Object(string.Create(CultureInfo.InvariantCulture, $"{prefix}/manager/{manager}"))
            .Text("name", names[manager], 60).Text("state", status.State.ToString())
            .Number("rate", _figures[manager].Rate, 1).Number("load", _figures[manager].Load * 100, 1)
            .Number("work", work.Mean.TotalMilliseconds, 2).Number("workMax", work.Max.TotalMilliseconds, 1)
            .Number("wake50", (wake.Percentile50 > TimeSpan.Zero ? wake.Percentile50 : wake.Mean).TotalMilliseconds, 2)
            .Number("wake99", (wake.Percentile99 > TimeSpan.Zero ? wake.Percentile99 : wake.Max).TotalMilliseconds, 2)
            .Count("missed", status.MissedDeadlines).Count("late", status.LateUnitsOfWork)
            .Count("faults", status.Faults).Count("hangs", status.Hangs).Count("restarts", status.Restarts)
            .Text("fault", status.LastFault ?? status.LastHang, 160).End();
    }

    private sealed class Figures
    {
        private (TimeSpan PostedAt, long Runs)? _runs;
        private (TimeSpan RealTime, TimeSpan Work)? _work;

        public double Rate { get; private set; } = double.NaN;

        public double Load { get; private set; } = double.NaN;

        public void Take(in ManagerMoment posted, in DurationStatistics work, TimeSpan realTime)
        {
            _runs ??= (posted.PostedAt, posted.Status.Runs);
            TimeSpan passed = posted.PostedAt - _runs.Value.PostedAt;
            if (passed >= Window)
            {
                Rate = (posted.Status.Runs - _runs.Value.Runs) / passed.TotalSeconds;
                _runs = (posted.PostedAt, posted.Status.Runs);
            }

            _work ??= (realTime, work.Total);
            TimeSpan real = realTime - _work.Value.RealTime;
            if (real < Window)
                return;
            Load = (work.Total - _work.Value.Work) / real;
            _work = (realTime, work.Total);
        }
    }
}
