using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>
/// Health Monitoring in virtual time beside managers of the test's, with the test in the place of everything that posts
/// what it fetches.
/// </summary>
internal sealed class HealthRig : IDisposable
{
    private readonly MessagePublisher<VehicleState> _vehicle;
    private readonly MessagePublisher<OwnAddress> _ownAddress;
    private readonly MessagePublisher<LinkStatus> _link;
    private readonly MessageSubscriber<HealthReport> _report;
    private readonly MessageSubscriber<PreflightReport> _preflight;
    private readonly MessagePublisher<MissionStatus> _mission;
    private readonly MessagePublisher<ImagingStatus> _imaging;
    private readonly MessagePublisher<NavigationStatus> _navigation;

    public HealthRig(params RabitManager[] others)
        : this(new VirtualTime(1), others)
    {
    }

    public HealthRig(VirtualTime time, params RabitManager[] others)
        : this(time, null, others)
    {
    }

    public HealthRig(VirtualTime time, HealthOptions? options, params RabitManager[] others)
    {
        Reactor = new RabitReactor(time) { Sink };
        foreach (RabitManager other in others)
            Reactor.Add(other);
        Reactor.Add(
            new HealthManager(
                options ?? new HealthOptions(), others.Select(m => m.Name).Concat([Sink.Name]), linkCount: 1));
        _vehicle = Reactor.Workspace.Publish<VehicleState>(MessageNames.VehicleState);
        _ownAddress = Reactor.Workspace.Publish<OwnAddress>(MessageNames.OwnAddress);
        _link = Reactor.Workspace.Publish<LinkStatus>(MessageNames.LinkStatus(0));
        _mission = Reactor.Workspace.Publish<MissionStatus>(MessageNames.Mission);
        Reactor.Workspace.Publish<AutopilotStatistics>(MessageNames.AutopilotStatistics);
        _navigation = Reactor.Workspace.Publish<NavigationStatus>(MessageNames.Navigation);
        _imaging = Reactor.Workspace.Publish<ImagingStatus>(MessageNames.Imaging);
        _report = Reactor.Workspace.Subscribe<HealthReport>(MessageNames.Health);
        _preflight = Reactor.Workspace.Subscribe<PreflightReport>(MessageNames.Preflight);
        Reactor.Workspace.Publish(MessageNames.AutopilotParameters, AutopilotParameters.None);
        Reactor.Start();
    }

    public RabitReactor Reactor { get; }

    public OutgoingSink Sink { get; } = new();

    public HealthReport Report
    {
        get
        {
            _report.Fetch();
            return _report.Value;
        }
    }

    public PreflightReport Preflight
    {
        get
        {
            _preflight.Fetch();
            return _preflight.Value;
        }
    }

    public int Reports
    {
        get
        {
            _report.Fetch();
            return _report.Stamp.Version;
        }
    }

    /// <summary>When heartbeats came, in seconds.</summary>
    public IReadOnlyList<double> BeatTimes
        => Sink.Frames.Where(f => f.Frame.MessageId == Heartbeat.MavlinkId).Select(f => f.Time.TotalSeconds).ToList();

    public void PostAddress(byte system = 1)
    {
        _ownAddress.Value = new OwnAddress { SystemId = system, ComponentId = 191 };
        _ownAddress.Post();
    }

    public void PostVehicle(
        double remaining = 0.8, bool isConnected = true, MavState state = MavState.Active, double wind = double.NaN)
    {
        _vehicle.Value = new VehicleState
        {
            SystemId = 1,
            IsConnected = isConnected,
            LastHeartbeatTime = Reactor.Now,
            SystemStatus = state,
            BatteryTime = Reactor.Now,
            BatteryRemaining = remaining,
            WindTime = double.IsNaN(wind) ? null : Reactor.Now,
            WindVelocityNed = new NedVector(wind, 0, 0),
        };
        _vehicle.Post();
    }

    public void PostVehicle(VehicleState state)
    {
        _vehicle.Value = state;
        _vehicle.Post();
    }

    public void PostNavigation(NavigationStatus status)
    {
        _navigation.Value = status;
        _navigation.Post();
    }

    public void PostMission(MissionPhase phase)
    {
        _mission.Value.Phase = phase;
        _mission.Post();
    }

    public void PostMission(MissionStatus status)
    {
        _mission.Value = status;
        _mission.Post();
    }

    public void PostEnergy(EnergyStatus energy)
    {
        _mission.Value.Energy = energy;
        _mission.Post();
    }

    public void PostImaging(
        ImagingMode mode, TimeSpan? lastFrame, bool hasCamera = true, long detectorFailures = 0,
        double? usableShare = null)
    {
        _imaging.Value = new ImagingStatus
        {
            HasCamera = hasCamera,
            Mode = mode,
            LastFrameTime = lastFrame,
            DetectorFailures = detectorFailures,
            UsableShare = usableShare,
            UnusableCause = PictureQuality.MotionBlurred,
            UnusableCauseShare = 1,
        };
        _imaging.Post();
    }

    public void PostLink(
        LinkState state = LinkState.Receiving, long dropped = 0, double progress = double.NaN, long droppedOut = 0,
        TimeSpan? groundStation = null)
    {
        _link.Value = new LinkStatus
        {
            State = state,
            Url = "udpin:0.0.0.0:14550",
            FramesDroppedIn = dropped,
            FramesDroppedOut = droppedOut,
            Progress = progress,
            GroundStationTime = groundStation,
        };
        _link.Post();
    }

    /// <summary>Runs, with a healthy vehicle that reports once a second.</summary>
    public void Fly(int seconds)
    {
        for (int i = 0; i < seconds; i++)
        {
            PostVehicle();
            PostLink();
            Reactor.RunFor(TimeSpan.FromSeconds(1));
        }
    }

    public void Run(double seconds) => Reactor.RunFor(TimeSpan.FromSeconds(seconds));

    public void Dispose()
    {
        Reactor.Stop();
        Reactor.Finish();
    }
}
