using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Communications;
using Rabit.Uav.GroundControl;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Reporting;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>A simulated search by all six managers in virtual time, and what came of it.</summary>
internal sealed class SearchFlight : IDisposable
{
    /// <summary>A small area, two lanes and a few minutes; see <see cref="SmallPlan"/>.</summary>
    public const string SmallMission =
        """
        {
          "name": "small",
          "area": [[47.39730, 8.54470], [47.39780, 8.54470], [47.39780, 8.54560], [47.39730, 8.54560]],
          "heightMetres": 30, "speedMetresPerSecond": 5, "laneSpacingMetres": 22,
          "targets": ["red", "orange", "blue", "yellow", "magenta"],
          "home": { "latitudeDegrees": 47.397100, "longitudeDegrees": 8.544500, "groundAltitudeAmslMetres": 488 }
        }
        """;

    private static readonly TimeSpan Step = TimeSpan.FromSeconds(1);

    private readonly UavSystem _uav;
    private readonly StringBuilder _log = new();
    private readonly MessageSubscriber<MissionStatus> _mission;
    private readonly MessageSubscriber<HealthReport> _health;
    private readonly MessageSubscriber<TrackList> _tracks;
    private readonly MessageSubscriber<ImagingStatus> _imaging;
    private readonly MessageSubscriber<CommandAuthority> _authority;
    private readonly MessageSubscriber<LinkStatus> _link;

    public SearchFlight(MissionPlan plan, SimulationOptions options, params RabitManager[] others)
        : this(plan, options, new VirtualTime(options.Seed), others)
    {
    }

    public SearchFlight(
        MissionPlan plan, SimulationOptions options, VirtualTime time, RabitManager[] others,
        MavlinkSigningKey? key = null, MavlinkSigningKey? vehicleKey = null, OnStop onStop = OnStop.Hold,
        Func<IByteLink, IByteLink>? around = null, IByteLink? groundStation = null,
        Action<MissionControlOptions>? change = null, GroundCommandOptions? commands = null)
    {
        var control = new MissionControlOptions { OnStop = onStop };
        change?.Invoke(control);
        options.TakePlacesFrom(plan);
        World = new SimulatedWorld(options);
        World.AddHangsTo(time);
        var link = new MemoryLinkPair("simulation");
        Camera = World.CreateCamera();
        _uav = UavSystem.Open(new UavOptions
        {
            MissionControl = control,
            OpenLinks =
            [
                around is null ? link.A : around(link.A),
                .. groundStation is null ? [] : new[] { groundStation },
            ],
            GroundCommands = groundStation is null ? null : commands ?? new GroundCommandOptions(),
            Mission = plan,
            MayCommand = true,
            Camera = Camera,
            Computer = options.Faults.Any(f => f.Kind is ScriptedFaultKind.ComputerHot
                or ScriptedFaultKind.ComputerUnderVoltage or ScriptedFaultKind.DiskLow)
                ? World.CreateComputer()
                : null,
            Imaging = new ImageProcessingOptions { Camera = World.CameraModel, Mount = World.CameraMount },
            OtherManagers = others,
            Time = time,
            Signing = key is null ? null : new SigningOptions(key),
        });
        Reactor = _uav.CreateReactor(new ReactorOptions { StopsOnSignals = false, Log = Write });
        Reactor.Add(World.CreateVehicle(link.B, vehicleKey ?? key));
        RabitWorkspace workspace = Reactor.Workspace;
        _mission = workspace.Subscribe<MissionStatus>(MessageNames.Mission);
        _health = workspace.Subscribe<HealthReport>(MessageNames.Health);
        _tracks = workspace.Subscribe<TrackList>(MessageNames.Tracks);
        _imaging = workspace.Subscribe<ImagingStatus>(MessageNames.Imaging);
        _authority = workspace.Subscribe<CommandAuthority>(MessageNames.CommandAuthority);
        _link = workspace.Subscribe<LinkStatus>(MessageNames.LinkStatus(0));
    }

    public SimulatedWorld World { get; }

    public SimulatedCamera Camera { get; }

    public RabitReactor Reactor { get; }

    public MissionControlManager Control => _uav.MissionControl;

    /// <summary>What managers said and what became of them, with the time of the run.</summary>
    public string Log => _log.ToString();

    public MissionStatus Mission => Latest(_mission);

    public HealthReport Health => Latest(_health);

    public TrackList Tracks => Latest(_tracks);

    public ImagingStatus Imaging => Latest(_imaging);

    public CommandAuthority Authority => Latest(_authority);

    public LinkStatus Link => Latest(_link);

    public ReactorResult? Result { get; private set; }

    public bool IsOver => Mission.Phase is MissionPhase.Done or MissionPhase.HandedOver or MissionPhase.Failed;

    /// <summary>The mission that UavConsole flies without arguments.</summary>
    public static MissionPlan BundledPlan() => MissionPlan.Parse(BundledText, "search");

    /// <summary>The bundled plan, which declares the classes that move in a world and follows such targets.</summary>
    /// <param name="options">Of the world, which takes its places from the plan.</param>
    /// <param name="revisit">The members of "revisit" in the mission file.</param>
    public static MissionPlan FollowingPlan(SimulationOptions options, string revisit)
    {
        options.TakePlacesFrom(BundledPlan());
        string motions = string.Join(", ", new SimulatedWorld(options).Targets
            .Where(t => t.Motion != SimulatedMotion.Standing)
            .Select(t => $"\"{t.Class}\": \"{(t.Motion == SimulatedMotion.Walking ? "walking" : "vehicle")}\""));
        string members = $"\"targetMotions\": {{ {motions} }}, \"revisit\": {{ {revisit} }}, ";
        return MissionPlan.Parse(BundledText.Replace("\"targets\"", members + "\"targets\""), "following");
    }

    /// <summary>As <see cref="SmallMission"/>.</summary>
    public static MissionPlan SmallPlan() => MissionPlan.Parse(SmallMission, "small");

    /// <summary>For flights in which the pictures are not the point.</summary>
    public static SimulationOptions SmallWorld(params ScriptedFault[] faults) => new()
    {
        Seed = 5,
        TargetCount = 2,
        DistractorCount = 1,
        Camera = SimulatedCameraOptions.CreateLowResolution(),
        Faults = faults,
    };

    /// <summary>The text of <see cref="BundledPlan"/>.</summary>
    public static string BundledText
        => File.ReadAllText(Path.Combine(AppContext.BaseDirectory, "data", "missions", "search.json"));


    /// <summary>Flies until the mission is over, and then until motors are off or the time limit is reached.</summary>
    public void Fly(TimeSpan atMost)
    {
        Reactor.Start();
        while (Reactor.Now < atMost && Reactor.RunFor(Step) && !IsOver)
        {
        }

        End();
    }

    public void FlyUntil(Func<SearchFlight, bool> condition, TimeSpan atMost)
    {
        if (!Reactor.IsWired)
            Reactor.Start();
        while (!condition(this) && Reactor.Now < atMost && Reactor.RunFor(TimeSpan.FromMilliseconds(100)))
        {
        }
    }

    public void End()
    {
        Reactor.Stop("the test is over");
        Result = Reactor.Finish();
    }

    /// <summary>The tracks compared with the true targets.</summary>
    public MissionScore Score() => TargetScoring.Score(TargetTruth.Of(World), Tracks.Tracks);

    public void Dispose() => _uav.Dispose();

    private void Write(RabitLogEntry entry) => _log.Append(entry).Append('\n');

    private static T Latest<T>(MessageSubscriber<T> subscriber)
    {
        subscriber.Fetch();
        return subscriber.Value;
    }
}
