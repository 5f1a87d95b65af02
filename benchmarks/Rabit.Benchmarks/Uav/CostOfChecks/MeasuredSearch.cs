using System;
using System.Collections.Generic;
using System.IO;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation;

namespace Rabit.Benchmarks.Uav.CostOfChecks;

/// <summary>The bundled mission with seed 1 in virtual time, with everything on, to the landing.</summary>
internal sealed class MeasuredSearch
{
    private static readonly TimeSpan Step = TimeSpan.FromMilliseconds(50);
    private static readonly TimeSpan MaxDuration = TimeSpan.FromMinutes(30);

    private readonly List<ReadMessages> _samples = [];

    private MeasuredSearch(bool isRecorded)
    {
        var options = new SimulationOptions { Seed = 1 };
        options.TakePlacesFrom(Plan);
        var world = new SimulatedWorld(options);
        var link = new MemoryLinkPair("simulation");
        Camera = new MeasuredCamera(world.CreateCamera());
        TimeSpan before = Environment.CpuUsage.TotalTime;
        using UavSystem uav = UavSystem.Open(new UavOptions
        {
            OpenLinks = [link.A],
            OtherManagers = [world.CreateVehicle(link.B)],
            Mission = Plan,
            MayCommand = true,
            Camera = Camera,
            Computer = world.CreateComputer(),
            Imaging = new ImageProcessingOptions { Camera = world.CameraModel, Mount = world.CameraMount },
            Time = new VirtualTime(options.Seed),
        });
        Fly(uav.CreateReactor(new ReactorOptions { StopsOnSignals = false }), isRecorded);
        Cpu = Environment.CpuUsage.TotalTime - before;
        if (world.Truth.Landing is null)
            throw new InvalidOperationException("The simulated search did not end with a landing.");
    }

    public static MissionPlan Plan { get; } = MissionPlan.Parse(
        File.ReadAllText(Path.Combine(AppContext.BaseDirectory, "data", "search.json")), "search.json");

    /// <summary>What was posted, every 50 ms; empty where it was not recorded.</summary>
    public IReadOnlyList<ReadMessages> Samples => _samples;

    public MeasuredCamera Camera { get; }

    public TimeSpan Duration { get; private set; }

    /// <summary>The time of the processor, that for the simulated world included.</summary>
    public TimeSpan Cpu { get; }

    public long HealthEvaluations { get; private set; }

    public long EnergyUpdates { get; private set; }

    public long PicturesJudged { get; private set; }

    public static MeasuredSearch Fly(bool isRecorded) => new(isRecorded);

    public static long RunsOf(RabitWorkspace workspace, string manager)
    {
        var status = workspace.Subscribe<ManagerStatus>(RabitManager.StatusMessageName(manager));
        status.Fetch();
        return status.Value.Runs;
    }

    private void Fly(RabitReactor reactor, bool isRecorded)
    {
        RabitWorkspace workspace = reactor.Workspace;
        var mission = workspace.Subscribe<MissionStatus>(MessageNames.Mission);
        var recorder = new SampleRecorder(workspace);
        reactor.Start();
        do
        {
            if (!reactor.RunFor(isRecorded ? Step : TimeSpan.FromSeconds(1)) || reactor.Now > MaxDuration)
                throw new InvalidOperationException("The simulated search did not end.");
            mission.Fetch();
            if (!isRecorded)
                continue;
            _samples.Add(recorder.Take(reactor.Now));
            Camera.Keeps = mission.Value.Phase == MissionPhase.Searching;
        }
        while (mission.Value.Phase is not (MissionPhase.Done or MissionPhase.HandedOver or MissionPhase.Failed));

        Duration = reactor.Now;
        HealthEvaluations = RunsOf(workspace, HealthManager.ManagerName);
        EnergyUpdates = RunsOf(workspace, MissionControlManager.ManagerName);
        PictureCounts pictures = recorder.Take(reactor.Now).Imaging.Pictures;
        PicturesJudged = pictures.Total - pictures.RepeatedNumber - pictures.NoPose - pictures.NotGround
            - pictures.NotSearched - pictures.TooCoarse;
        reactor.Stop();
        reactor.Finish();
    }
}
