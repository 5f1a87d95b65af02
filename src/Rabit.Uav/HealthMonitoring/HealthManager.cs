using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// Monitors the managers, the autopilot, the battery and the links, and reports their health. It sends our MAVLink
/// heartbeat, once a second and only while it is true: an unknown address, a manager that faulted or that hangs stops
/// it. In flight it advises Mission Control to return to launch or to land, where a rule says so.
/// </summary>
public sealed partial class HealthManager : RabitManager
{
    /// <summary>The name of the manager.</summary>
    public const string ManagerName = "health";

    /// <summary>How often the rules are evaluated.</summary>
    internal static readonly TimeSpan EvaluationPeriod = TimeSpan.FromMilliseconds(250);

    // MAVLink guide, "Heartbeat/Connection Protocol": 1 Hz.
    private static readonly TimeSpan HeartbeatPeriod = TimeSpan.FromSeconds(1);

    // Mission Control posts it once a second.
    private static readonly TimeSpan MaxEnergyAge = TimeSpan.FromSeconds(5);

    private readonly HealthOptions _options;
    private readonly ManagerWatch[] _managers;
    private readonly LinkWatch[] _links;
    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly MessageSubscriber<AutopilotStatistics> _autopilot;
    private readonly MessageSubscriber<OwnAddress> _ownAddress;
    private readonly MessageSubscriber<MissionStatus> _mission;
    private readonly CameraWatch _camera;
    private readonly AdviceLatch _advice = new();
    private readonly StatusTextSender _texts;
    // What finds no room is counted by the queue, and shown; each protocol sends again what is not answered.
    private readonly QueueSender<OutgoingFrame> _outgoing;
    private readonly MessagePublisher<HealthReport> _report;
    private readonly HeartbeatSchedule _schedule = new(HeartbeatPeriod, EvaluationPeriod);
    private List<HealthFinding> _findings = [];
    private List<HealthFinding> _lastFindings = [];
    private HealthReport _next;
    private bool _isImagingStuck;
    private TimeSpan? _monitoredSince;

    /// <summary>Makes the manager.</summary>
    /// <param name="options">Checked and read now; later changes have no effect.</param>
    /// <param name="managerNames">
    /// The managers to monitor, which must be in the same reactor; this one is monitored too, named or not.
    /// </param>
    /// <param name="linkCount">How many links Communications has; their numbers are 0 to one less.</param>
    /// <exception cref="ArgumentException">
    /// Options are out of their range (the text names all of them), or a manager is named twice.
    /// </exception>
    /// <exception cref="ArgumentOutOfRangeException">The number of links is negative.</exception>
    public HealthManager(HealthOptions options, IEnumerable<string> managerNames, int linkCount)
        : base(ManagerName)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options))).ValidatedCopy(nameof(options));
        if (linkCount < 0)
            throw new ArgumentOutOfRangeException(
                nameof(linkCount), linkCount, "The number of links cannot be negative.");
        _managers = NamesToMonitor(managerNames)
            .Select(name => new ManagerWatch(name, SubscribeToStatus(name))).ToArray();
        _links = Enumerable.Range(0, linkCount)
            .Select(number => new LinkWatch(number, Subscribe<LinkStatus>(MessageNames.LinkStatus(number)))).ToArray();
        _vehicle = Subscribe<VehicleState>(MessageNames.VehicleState);
        _autopilot = Subscribe<AutopilotStatistics>(MessageNames.AutopilotStatistics);
        _navigation = Subscribe<NavigationStatus>(MessageNames.Navigation);
        _ownAddress = Subscribe<OwnAddress>(MessageNames.OwnAddress);
        _mission = Subscribe<MissionStatus>(MessageNames.Mission);
        _camera = new CameraWatch(Subscribe<ImagingStatus>(MessageNames.Imaging));
        _texts = new StatusTextSender(_options.StatusTextPeriod);
        _outgoing = Send<OutgoingFrame>(MessageNames.OutgoingFrames);
        _next.Computer = ComputerStatus.Unknown;
        _report = Publish(MessageNames.Health, _next);
        _recording = _options.WatchesRecording ? Subscribe<RecordingStatus>(MessageNames.Recording) : null;
        _computer = MakeComputer(_options.Computer);
        _preflight = MakePreflight(_options.Preflight, linkCount);
        WakeUpDelay = EvaluationPeriod;
    }

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork()
    {
        TimeSpan now = Now;
        _monitoredSince ??= now;
        Evaluate(now, _monitoredSince.Value);
        if (_schedule.TakeBeat(now))
        {
            if (_next.SendsHeartbeat)
                SendHeartbeat();
            SendComputerStatus(now);
            SendEnergy(now);
        }

        SendTexts(now);
        PostReport(now);
        ComputerStatus computer = new ComputerFacts(_next.Computer, now).Status;
        _preflight?.Update(now, _vehicle.Value, _ownAddress.Value, computer, _mission.Value.Phase);
        WakeUpDelay = _schedule.UntilNext(now);
    }

    private static List<string> NamesToMonitor(IEnumerable<string> managerNames)
    {
        List<string> names = (managerNames ?? throw new ArgumentNullException(nameof(managerNames))).ToList();
        foreach (IGrouping<string, string> twice
            in names.GroupBy(n => n, StringComparer.Ordinal).Where(g => g.Count() > 1))
            throw new ArgumentException(
                $"Health Monitoring: manager '{twice.Key}' is named more than once.", nameof(managerNames));
        if (!names.Contains(ManagerName, StringComparer.Ordinal))
            names.Add(ManagerName);
        return names;
    }

    private void Evaluate(TimeSpan now, TimeSpan monitoredSince)
    {
        _findings.Clear();
        bool areAllAlive = EvaluateManagers(now, monitoredSince);
        bool isReplayOver = EvaluateLinks(now, monitoredSince);
        EvaluateRecording(now);
        EvaluateVehicle(now, isReplayOver);
        EvaluateGroundStation(now, isReplayOver);
        EvaluateComputer(now);
        _ownAddress.Fetch();
        UpdateAdvice();
        _next.SendsHeartbeat = areAllAlive && _ownAddress.Value.IsKnown;
        UpdateReport();
    }

    /// <returns>Whether every manager works.</returns>
    private bool EvaluateManagers(TimeSpan now, TimeSpan monitoredSince)
    {
        bool areAllAlive = true;
        foreach (ManagerWatch watch in _managers)
        {
            ManagerFacts manager = watch.Update(now, monitoredSince, _options);
            watch.Rules.Evaluate(manager, manager.Name, _options, now, _findings);
            bool isAlive = HealthRules.IsAlive(manager, _options);
            if (string.Equals(watch.Name, _options.CameraManager, StringComparison.Ordinal))
                _isImagingStuck = !isAlive;
            areAllAlive &= isAlive;
        }

        return areAllAlive;
    }

    /// <returns>Whether all links are recorded logs that have ended.</returns>
    private bool EvaluateLinks(TimeSpan now, TimeSpan monitoredSince)
    {
        bool isReplayOver = _links.Length > 0;
        foreach (LinkWatch watch in _links)
        {
            LinkFacts link = watch.Update(now, monitoredSince, _options);
            watch.Rules.Evaluate(link, link.Name, _options, now, _findings);
            isReplayOver &= link.IsRecorded && link.State == LinkState.Ended;
        }

        return isReplayOver;
    }

    // Advice is for a mission in flight; otherwise findings are only reported.
    private void UpdateAdvice()
    {
        bool isFlying = _mission.Value.Phase is MissionPhase.Arming or MissionPhase.TakingOff or MissionPhase.InTransit
            or MissionPhase.Searching or MissionPhase.Revisiting or MissionPhase.Holding or MissionPhase.Returning
            or MissionPhase.Landing;
        _advice.Update(_findings, isFlying);
        _next.Advice = _advice.Advice;
        _next.AdviceText = _advice.Text;
    }
}
