using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;
using Rabit.Uav.Reporting.Tests;

namespace UavConsole.Tests;

/// <summary>The screen of a mission that managers without work post about.</summary>
internal sealed class MissionScreen
{
    private static readonly string[] ManagerNames =
    [
        "communications", "autopilot", "image processing", "sensor fusion", "mission control", "health",
        "simulated vehicle"
    ];

    private readonly List<Action> _posts = [];

    public LiveScreen Open(
        string missionText, TargetClassName colour, MissionPhase phase = MissionPhase.Searching, bool isArmed = true,
        PreflightReport? checklist = null, IKeyHints? keys = null, int targets = 1)
    {
        var notes = new RunLog();
        var reactor = new RabitReactor(
            new ReactorOptions { Time = new VirtualTime(1), Log = notes.Add, StopsOnSignals = false });
        foreach (string name in ManagerNames)
            reactor.Add(new IdleManager(name));
        var recorder = new FlightRecorderManager(new FlightRecorderOptions { ManagerNames = ManagerNames });
        reactor.Add(recorder);
        Post(reactor.Workspace, MessageNames.VehicleState, Vehicle() with { IsArmed = isArmed });
        Post(reactor.Workspace, MessageNames.Health, new HealthReport { Level = HealthLevel.Good });
        Post(reactor.Workspace, MessageNames.Imaging, Camera());
        Post(reactor.Workspace, MessageNames.Mission, new MissionStatus
        {
            Phase = phase,
            Plan = MadeUpSite.Plan,
            Coverage = 0.62,
            LanesFlown = 1,
            Text = missionText,
        });
        TargetTrack[] tracks = [.. Enumerable.Range(1, targets).Select(n => Track(n, colour))];
        Post(reactor.Workspace, MessageNames.Tracks, new TrackList(TimeSpan.Zero, tracks));
        reactor.Workspace.Publish(MessageNames.StatusTexts, RecentItems<StatusText>.None);
        reactor.Workspace.Publish(MessageNames.Preflight, checklist ?? PreflightReport.None);
        var monitor = new FlightMonitor(reactor, recorder, linkCount: 0);
        var screen = new LiveScreen(monitor, notes, showsMission: true, keys: keys);
        reactor.Start();
        foreach (Action post in _posts)
            post();
        reactor.RunFor(TimeSpan.FromSeconds(2));
        monitor.Refresh();
        reactor.Stop();
        reactor.Finish();
        return screen;
    }

    private void Post<T>(RabitWorkspace workspace, string name, T value)
    {
        MessagePublisher<T> publisher = value is TrackList
            ? workspace.Publish(name, value)
            : workspace.Publish<T>(name);
        _posts.Add(() =>
        {
            publisher.Value = value;
            publisher.Post();
        });
    }

    private static VehicleState Vehicle() => new()
    {
        SystemId = 1,
        ComponentId = 1,
        IsConnected = true,
        IsArmed = true,
        Mode = "GUIDED",
        PositionTime = TimeSpan.Zero,
        Position = MadeUpSite.Frame.ToGeodetic(new NedPosition(65, 90, -40)),
        HeightAboveHomeMetres = 40.2,
        VelocityNed = new NedVector(0, -6, 0),
        Attitude = EulerAngles.FromRadians(0, 0, -Math.PI / 2),
        BatteryTime = TimeSpan.Zero,
        BatteryRemaining = 0.87,
        BatteryVolts = 15.9,
        BatteryAmperes = 14,
        WindTime = TimeSpan.Zero,
        WindVelocityNed = new NedVector(0, 5, 0),
        GpsTime = TimeSpan.Zero,
        Satellites = 14,
    };

    private static ImagingStatus Camera() => new()
    {
        HasCamera = true,
        UsableShare = 0.96,
        Frames = 120,
        LastPicture = new PictureFacts
        {
            Exposure = TimeSpan.FromMilliseconds(2),
            DarkLevel = 61,
            BrightLevel = 182,
            ClippedShare = 0.031,
            Sharpness = 0.34,
            Detections = 2,
        },
    };

    private static TargetTrack Track(int id, TargetClassName colour) => new()
    {
        Id = id,
        Class = colour,
        State = TrackState.Confirmed,
        Reports = 12,
        Covariance = new HorizontalCovariance(1, 0, 1),
        Position = MadeUpSite.Frame.ToGeodetic(new NedPosition(48, 59 + id, 0)),
    };

    private sealed class IdleManager(string name) : RabitManager(name)
    {
        protected override void ExecuteUnitOfWork() => Log("a note");
    }
}
