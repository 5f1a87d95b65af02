using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav;
using Rabit.Uav.GroundControl;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Reporting;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>Several simulated vehicles that search one area together.</summary>
internal sealed class GroupFlight : IDisposable
{
    // Between two layers: 15 m are needed, and the heights of two vehicles are wrong by up to 4 m against each other.
    public const double DefaultLayerSpacingMetres = 20;

    // From three vehicles on the layers begin so much lower, at this height or more: the third one still sees the
    // smallest target of the bundled mission.
    private const double LowerMetres = 5;
    private const double MinLoweredMetres = 20;

    // A little to the side, so that no vehicle lands on it.
    private const double StationNorthMetres = -10;

    private static readonly TimeSpan RadioSamplePeriod = TimeSpan.FromSeconds(1);

    private TimeSpan _nextRadioSample;

    private GroupFlight(
        SimulatedGroup group, MissionFile file, MissionPlan mission, ConsoleOptions options, LogFile? log)
    {
        (Group, MissionFile, Mission) = (group, file, options.Look.Declare(mission, group.Vehicles[0].World));
        SimulatedGroundStation station = group.GroundStations[0];
        Station = new GroupStation(
            station, options.Commands, new RunLog(log, $"station {FlightText.Number(station.SystemId)}: "));
    }

    /// <summary>For the thread that simulates.</summary>
    public SimulatedGroup Group { get; }

    public MissionFile MissionFile { get; }

    public MissionPlan Mission { get; }

    public List<GroupVehicle> Vehicles { get; } = [];

    /// <summary>Commands one vehicle or all by radio.</summary>
    public GroupStation Station { get; }

    /// <summary>The time of the vehicles. Any thread.</summary>
    public TimeSpan Now => Vehicles.Max(v => v.Monitor.Now);

    /// <summary>Where the targets really are.</summary>
    public TargetTruth Truth => TargetTruth.Of(Group.Vehicles[0].World, Mission.Targets);

    /// <exception cref="ArgumentException">Options or files are wrong; the text says what.</exception>
    public static GroupFlight Open(ConsoleOptions options, LogFile? log)
    {
        MissionFile file = Flight.ReadSimulatedMission(options);
        MissionPlan mission = Lower(file.Plan, options);
        var world = new SimulationOptions
        {
            Seed = options.Seed,
            TargetCount = options.TargetCount,
            Autopilot = options.Autopilot,
            Motions = SimulatedMotions.MotionsOf(options.MovingCount),
        };
        options.Look.ApplyTo(world);
        world.TakePlacesFrom(mission);
        var flight = new GroupFlight(
            new SimulatedGroup(new SimulatedGroupOptions
            {
                Vehicles = options.Vehicles,
                World = world,
                GroundStations = [new SimulatedStationPlace(StationNorthMetres, 0)],
            }),
            file, mission, options, log);
        try
        {
            for (int i = 0; i < options.Vehicles; i++)
                flight.Add(options, i, log);
        }
        catch
        {
            flight.Dispose();
            throw;
        }

        return flight;
    }

    /// <summary>Notes once a second what each vehicle has sent. The thread that simulates.</summary>
    public void SampleRadio()
    {
        if (Group.Now < _nextRadioSample)
            return;
        _nextRadioSample += RadioSamplePeriod;
        foreach (GroupVehicle vehicle in Vehicles)
            vehicle.RadioSamples.Add(new RadioSample(Group.Now, Group.RadioOf(vehicle.Number).BytesSent));
    }

    public void Dispose()
    {
        Group.Finish();
        foreach (GroupVehicle vehicle in Vehicles)
            vehicle.Uav.Dispose();
    }

    private static MissionPlan Lower(MissionPlan mission, ConsoleOptions options)
    {
        double lower = mission.HeightMetres - LowerMetres;
        bool isLower = options.Vehicles > 2 && lower >= MinLoweredMetres;
        return isLower ? mission.WithHeight(lower) : mission;
    }

    private void Add(ConsoleOptions options, int number, LogFile? file)
    {
        SimulatedGroupVehicle simulated = Group.Vehicles[number];
        var telemetry = new MemoryLinkPair("vehicle");
        var uavOptions = new UavOptions
        {
            Subscriptions = [FlightRecorderManager.CreateSubscription()],
            OpenLinks = [telemetry.A, simulated.Radio],
            OtherManagers = [simulated.World.CreateVehicle(telemetry.B)],
            Mission = Mission,
            MayCommand = true,
            GroundCommands = new GroundCommandOptions { SystemIds = [Station.Station.SystemId] },
            Camera = simulated.World.CreateCamera(),
            Time = simulated.Time,
            Imaging = { Camera = simulated.World.CameraModel, Mount = simulated.World.CameraMount },
            Communications =
            {
                LinkSettings = new Dictionary<int, LinkSettings>
                {
                    [0] = SimulatedGroupVehicle.TelemetrySettings,
                    [1] = simulated.RadioSettings,
                },
            },
            MissionControl =
            {
                Group = new GroupOptions
                {
                    HeightLayer = number,
                    LayerSpacingMetres = options.LayerSpacingMetres ?? DefaultLayerSpacingMetres,
                },
            },
        };
        uavOptions.Fusion.TargetMotions =
            uavOptions.Fusion.TargetMotions.SetItems(SimulatedMotions.Declare(Mission, simulated.World));
        options.Preflight.ApplyTo(uavOptions, Mission, isSimulated: true);
        options.Operator.ApplyTo(uavOptions.MissionControl);
        var log = new RunLog(file, $"vehicle {FlightText.Number(number + 1)}: ");
        UavSystem uav = Open(uavOptions, number);
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions { StopsOnSignals = false, Log = log.Add });
        Vehicles.Add(new GroupVehicle(number, simulated, uav, reactor, log));
        Group.Attach(number, reactor);
    }

    private static UavSystem Open(UavOptions options, int number)
    {
        try
        {
            return UavSystem.Open(options);
        }
        catch (ArgumentException e)
        {
            throw new ArgumentException(
                $"vehicle {FlightText.Number(number + 1)}: {FaultLine.FirstOf(e.Message)}", nameof(options), e);
        }
    }
}
