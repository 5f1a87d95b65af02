using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;

namespace UavConsole;

/// <summary>
/// What a view shows: subscribers of its own for the messages of the managers. One thread, that of the view.
/// </summary>
internal sealed class FlightMonitor
{
    private readonly RabitReactor _reactor;
    private readonly FlightRecorderManager _recorder;
    private readonly Stopwatch _wall = new();
    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly MessageSubscriber<MissionStatus> _mission;
    private readonly MessageSubscriber<HealthReport> _health;
    private readonly MessageSubscriber<RecentItems<StatusText>> _texts;
    private readonly MessageSubscriber<PreflightReport> _preflight;
    private readonly List<MessageSubscriber<LinkStatus>> _links;
    private readonly List<MessageSubscriber<ManagerStatus>> _managers;

    /// <param name="reactor">With all managers in it, not started.</param>
    /// <param name="recorder">One of them.</param>
    /// <param name="linkCount">How many links Communications has.</param>
    public FlightMonitor(RabitReactor reactor, FlightRecorderManager recorder, int linkCount)
    {
        _reactor = reactor;
        _recorder = recorder;
        RabitWorkspace workspace = reactor.Workspace;
        _vehicle = workspace.Subscribe<VehicleState>(MessageNames.VehicleState);
        _mission = workspace.Subscribe<MissionStatus>(MessageNames.Mission);
        _health = workspace.Subscribe<HealthReport>(MessageNames.Health);
        _texts = workspace.Subscribe<RecentItems<StatusText>>(MessageNames.StatusTexts);
        _preflight = workspace.Subscribe<PreflightReport>(MessageNames.Preflight);
        _links = Enumerable.Range(0, linkCount)
            .Select(n => workspace.Subscribe<LinkStatus>(MessageNames.LinkStatus(n))).ToList();
        ManagerNames = reactor.Select(m => m.Name).ToList();
        _managers = ManagerNames.Select(workspace.SubscribeToStatus).ToList();
    }

    public IReadOnlyList<string> ManagerNames { get; }

    public VehicleState Vehicle { get; private set; }

    public HealthReport Health { get; private set; }

    public PreflightReport Preflight { get; private set; } = PreflightReport.None;

    public IReadOnlyCollection<StatusText> Texts { get; private set; } = [];

    public IReadOnlyList<LinkStatus> Links { get; private set; } = [];

    public IReadOnlyList<ManagerStatus> Managers { get; private set; } = [];

    /// <summary>Called with what the recorder has kept and the health, at each refresh.</summary>
    public Action<FlightRecord, HealthReport> Refreshed { get; init; } = (_, _) => { };

    /// <summary>What the recorder has kept.</summary>
    public FlightRecord Record { get; private set; } = FlightRecord.Empty;

    /// <summary>How many seconds of the flight pass in a real one, on the average; 0 before the start.</summary>
    public double Pace => _wall.Elapsed.TotalSeconds > 0.2 ? _reactor.Now.TotalSeconds / _wall.Elapsed.TotalSeconds : 0;

    /// <summary>How far the slowest replay is, 0 to 1; null when no log is played.</summary>
    public double? Progress
    {
        get
        {
            double[] progress = Links.Select(l => l.Progress).Where(p => !double.IsNaN(p)).ToArray();
            return progress.Length == 0 ? null : progress.Min();
        }
    }

    public TimeSpan Now => _reactor.Now;

    /// <summary>
    /// How long the units of work of a manager really take: by its status in real time, beside it in virtual time.
    /// </summary>
    public DurationStatistics UnitOfWorkTimeOf(int manager)
    {
        DurationStatistics real = _reactor.RealStepTime(ManagerNames[manager]);
        return real.Count > 0 ? real : Managers[manager].UnitOfWorkTime;
    }

    /// <summary>Fetches all news; there is none before the managers are wired.</summary>
    public void Refresh()
    {
        if (!_reactor.IsWired)
            return;
        if (!_wall.IsRunning)
            _wall.Start();
        Vehicle = Latest(_vehicle);
        Record = _recorder.Record.WithLatest(Latest(_mission), Vehicle);
        Health = Latest(_health);
        Texts = Latest(_texts);
        Preflight = Latest(_preflight) ?? PreflightReport.None;
        Links = _links.ConvertAll(Latest);
        Managers = _managers.ConvertAll(Latest);
        Refreshed(Record, Health);
    }

    private static T Latest<T>(MessageSubscriber<T> subscriber)
    {
        subscriber.Fetch();
        return subscriber.Value;
    }
}
