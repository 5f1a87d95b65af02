using System;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.Communications;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Quality;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.SensorFusion;
using Rabit.Uav.Simulation;

namespace Rabit.Benchmarks.Uav.CostOfChecks;

/// <summary>The checks of a recorded flight, each done alone: the time of the processor for one.</summary>
internal sealed class CheckParts(MeasuredSearch flight)
{
    private const int Repeats = 10;
    private const int PictureRepeats = 100;

    // Pictures are searched from 40 m, at which the smallest class may be seen with more than twice that sampling.
    private const double GroundSamplingMetres = 0.075;
    private const double NeededSamplingMetres = 0.15;
    private const double MetresPerPicture = 5;

    private static readonly string[] Watched =
    [
        CommunicationsManager.ManagerName, AutopilotManager.ManagerName, ImageProcessingManager.ManagerName,
        SensorFusionManager.ManagerName, MissionControlManager.ManagerName,
    ];

    private readonly LocalNedFrame _centre = LocalNedFrame.IgnoringGeoid(flight.Samples[0].Vehicle.Position);

    private static TimeSpan Cpu => Environment.CpuUsage.TotalTime;

    /// <summary>
    /// Health Monitoring with all that it does besides the rules, less a run of the same managers without it.
    /// </summary>
    public double HealthMicroseconds()
    {
        long runs = 0;
        TimeSpan with = TimeSpan.Zero;
        TimeSpan without = TimeSpan.Zero;
        for (int i = 0; i < Repeats; i++)
        {
            var options = new HealthOptions
            {
                Computer = new SimulatedWorld(new SimulationOptions()).CreateComputer(),
                CameraManager = ImageProcessingManager.ManagerName,
            };
            with += Run(new HealthManager(options, Watched, linkCount: 1), out long evaluations);
            without += Run(health: null, out _);
            runs += evaluations;
        }

        return (with - without).TotalMicroseconds / runs;
    }

    public double EnergyMicroseconds()
    {
        TimeSpan cpu = TimeSpan.Zero;
        long known = 0;
        long updates = 0;
        for (int i = 0; i < Repeats; i++)
        {
            MissionFlight mission = CreateMission();
            TimeSpan before = Cpu;
            foreach (ReadMessages sample in flight.Samples)
            {
                (mission.Now, mission.Vehicle, mission.VehicleReportTime) = (sample.Time, sample.Vehicle, sample.Time);
                mission.Energy.Update(mission);
                known += mission.Energy.Status.IsKnown ? 1 : 0;
            }

            cpu += Cpu - before;
            updates += flight.Samples.Count;
        }

        if (known < updates / 2)
            throw new InvalidOperationException("The energy was not known in most of the flight.");
        return cpu.TotalMicroseconds / updates;
    }

    public double PictureMicroseconds()
    {
        var judge = new PictureJudge();
        var view = new PictureView
        {
            GroundSamplingMetres = GroundSamplingMetres,
            NeededSamplingMetres = NeededSamplingMetres,
        };
        int usable = 0;
        int number = 0;
        TimeSpan before = Cpu;
        for (int i = 0; i < PictureRepeats; i++)
        {
            foreach (byte[] picture in flight.Camera.Kept)
            {
                view.Centre = _centre.ToGeodetic(new NedPosition(MetresPerPicture * number++, 0, 0));
                PictureQuality quality = judge.Judge(picture, flight.Camera.Width, flight.Camera.Height, view);
                usable += quality == PictureQuality.Usable ? 1 : 0;
            }
        }

        double microseconds = (Cpu - before).TotalMicroseconds;
        return number > 0 && usable == number
            ? microseconds / number
            : throw new InvalidOperationException($"{usable} of {number} pictures of the flight were usable.");
    }

    // Planned as in the flight, where that was when the vehicle was ready.
    private MissionFlight CreateMission()
    {
        var options = new MissionControlOptions { Mission = MeasuredSearch.Plan };
        var mission = new MissionFlight(
            MeasuredSearch.Plan, options, new CommandDispatcher(_ => true, _ => { }), _ => { },
            new OperatorActions(_ => true));
        ReadMessages ready = flight.Samples.First(s => s.Mission.Plan is not null);
        (mission.Now, mission.Vehicle, mission.VehicleReportTime) = (ready.Time, ready.Vehicle, ready.Time);
        return mission.CreatePlan() is { Length: > 0 } why
            ? throw new InvalidOperationException(why)
            : mission;
    }

    private TimeSpan Run(HealthManager? health, out long evaluations)
    {
        var reactor = new RabitReactor(new VirtualTime(seed: 1));
        reactor.Add(new SampleManager(flight.Samples));
        foreach (string name in Watched)
            reactor.Add(new WatchedManager(name));
        if (health is not null)
            reactor.Add(health);
        reactor.Start();
        TimeSpan before = Cpu;
        reactor.RunFor(flight.Duration);
        TimeSpan cpu = Cpu - before;
        evaluations = health is null ? 0 : MeasuredSearch.RunsOf(reactor.Workspace, HealthManager.ManagerName);
        reactor.Stop();
        ReactorResult result = reactor.Finish();
        return result.ExitCode == 0 ? cpu : throw new InvalidOperationException(result.ToString());
    }
}
