using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav.Communications;
using Rabit.Uav.GroundControl;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Simulation.Tests.Group;

/// <summary>A simulated group in which each vehicle is a whole companion computer that flies one mission.</summary>
internal sealed class GroupFlight : IDisposable
{
    private readonly List<UavSystem> _systems = [];
    private readonly List<MessageSubscriber<MissionStatus>> _missions = [];
    private readonly List<MessageSubscriber<GroupStatus>> _groups = [];
    private readonly List<MessageSubscriber<TrackList>> _tracks = [];
    private readonly List<MessageSubscriber<VehicleState>> _states = [];
    private readonly List<StringBuilder> _logs = [];
    private readonly Action<int, RabitReactor>? _wire;
    private readonly bool _isGroup;
    private readonly SendBudget? _radioBudget;

    public GroupFlight(
        MissionPlan plan,
        SimulatedGroupOptions options,
        double layerSpacingMetres,
        bool hasEventLogs = false,
        Action<int, RabitReactor>? wire = null,
        bool isGroup = true,
        SendBudget? radioBudget = null)
    {
        (_wire, _isGroup, _radioBudget) = (wire, isGroup, radioBudget);
        options.World.TakePlacesFrom(plan);
        Group = new SimulatedGroup(options);
        for (int i = 0; i < options.Vehicles; i++)
            Add(plan, i, layerSpacingMetres, hasEventLogs);
    }

    public SimulatedGroup Group { get; }

    public List<StringWriter> EventLogs { get; } = [];

    public string Log => string.Join(
        Environment.NewLine, _logs.Select((l, i) => FormattableString.Invariant($"--- vehicle {i + 1}\n") + l));

    public string LogOf(int vehicle) => _logs[vehicle].ToString();

    public MissionStatus Mission(int vehicle)
        => Group.Vehicles[vehicle].HasStarted ? Latest(_missions[vehicle]) : default;

    public GroupStatus GroupStatus(int vehicle) => Latest(_groups[vehicle]);

    public TrackList Tracks(int vehicle) => Latest(_tracks[vehicle]);

    public VehicleState Vehicle(int vehicle) => Latest(_states[vehicle]);

    /// <returns>Whether it came so.</returns>
    public bool RunUntil(Func<bool> condition, double maxSeconds)
    {
        TimeSpan end = Group.Now + TimeSpan.FromSeconds(maxSeconds);
        while (Group.Now < end)
        {
            if (condition())
                return true;
            Group.Step();
        }

        return condition();
    }

    public bool RunToEnd(double maxSeconds = 1800) => RunUntil(
        () => Enumerable.Range(0, _missions.Count).All(
            i => Group.Vehicles[i].IsLost
                || Mission(i).Phase is MissionPhase.Done or MissionPhase.Failed or MissionPhase.HandedOver),
        maxSeconds);

    public void Dispose()
    {
        Group.Finish();
        foreach (UavSystem system in _systems)
            system.Dispose();
    }

    private void Add(MissionPlan plan, int number, double layerSpacingMetres, bool hasEventLog)
    {
        SimulatedGroupVehicle vehicle = Group.Vehicles[number];
        var telemetry = new MemoryLinkPair("telemetry");
        if (hasEventLog)
        {
            EventLogs.Add(new StringWriter());
            vehicle.Time.EventLog = EventLogs[number];
        }

        UavSystem uav = UavSystem.Open(new UavOptions
        {
            OpenLinks = [telemetry.A, vehicle.Radio],
            Mission = plan,
            MayCommand = true,
            Camera = vehicle.World.CreateCamera(),
            Imaging = { Camera = vehicle.World.CameraModel, Mount = vehicle.World.CameraMount },
            Time = vehicle.Time,
            GroundCommands = new GroundCommandOptions { SystemIds = [255, 254] },
            MissionControl = new MissionControlOptions
            {
                Group = _isGroup
                    ? new GroupOptions { HeightLayer = number, LayerSpacingMetres = layerSpacingMetres }
                    : null,
            },
            Communications =
            {
                LinkSettings = new Dictionary<int, LinkSettings>
                {
                    [0] = SimulatedGroupVehicle.TelemetrySettings,
                    [1] = vehicle.RadioSettings,
                },
                SendBudgets = _radioBudget is null ? [] : new Dictionary<int, SendBudget> { [1] = _radioBudget },
            },
        });
        _systems.Add(uav);
        var log = new StringBuilder();
        _logs.Add(log);
        RabitReactor reactor = uav.CreateReactor(
            new ReactorOptions { StopsOnSignals = false, Log = entry => log.Append(entry).Append('\n') });
        reactor.Add(vehicle.World.CreateVehicle(telemetry.B));
        _missions.Add(reactor.Workspace.Subscribe<MissionStatus>(MessageNames.Mission));
        if (_isGroup)
            _groups.Add(reactor.Workspace.Subscribe<GroupStatus>(MessageNames.Group));
        _tracks.Add(reactor.Workspace.Subscribe<TrackList>(MessageNames.Tracks));
        _states.Add(reactor.Workspace.Subscribe<VehicleState>(MessageNames.VehicleState));
        _wire?.Invoke(number, reactor);
        Group.Attach(number, reactor);
    }

    private static T Latest<T>(MessageSubscriber<T> subscriber)
    {
        subscriber.Fetch();
        return subscriber.Value;
    }
}
