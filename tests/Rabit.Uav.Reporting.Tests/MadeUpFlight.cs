using System;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>
/// A search flight as it might be recorded: lanes over an area, five targets, one of them not found, one track too
/// many.
/// </summary>
internal static class MadeUpFlight
{
    private static readonly string[] ManagerNames =
    [
        "communications", "autopilot", "image processing", "sensor fusion", "mission control", "health",
        "simulated vehicle", "recorder"
    ];

    /// <param name="finds">How many of the five targets are found.</param>
    /// <param name="hasFalseTrack">Whether a track is confirmed where there is nothing.</param>
    /// <param name="group">What it knows of its group.</param>
    /// <param name="roles">What it did for it.</param>
    public static FlightRecord Record(
        int finds = 5, bool hasFalseTrack = false, GroupStatus group = default, GroupRole[]? roles = null)
    {
        var flight = new MadeUpPath();
        return new FlightRecord
        {
            Samples = flight.Samples,
            Observations = flight.Observations,
            Phases = flight.Phases,
            HealthChanges =
            [
                new HealthChange(TimeSpan.FromSeconds(0.25), new HealthReport
                {
                    Level = HealthLevel.Warning,
                    Reasons = HealthReasons.NoAutopilot,
                    Text = "no autopilot is connected yet"
                }),
                new HealthChange(TimeSpan.FromSeconds(1.5), new HealthReport { Level = HealthLevel.Good }),
                new HealthChange(TimeSpan.FromSeconds(88), new HealthReport
                {
                    Level = HealthLevel.Warning,
                    Reasons = HealthReasons.LinkSilent,
                    Text = "link 0 udpin:0.0.0.0:14550 has been silent for 3 s"
                }),
                new HealthChange(TimeSpan.FromSeconds(96), new HealthReport { Level = HealthLevel.Good }),
            ],
            Managers = ManagerNames.Select(flight.TimeLine).ToArray(),
            Mission = new MissionStatus
            {
                Phase = MissionPhase.Done,
                Plan = MadeUpSite.Plan,
                Coverage = 0.993,
                LanesFlown = 4,
                Revisits = finds,
                Text = "landed",
                Energy = new EnergyStatus
                {
                    IsKnown = true,
                    ChargeLeft = 0.58,
                    ChargeLeftDeviation = 0.03,
                    CapacityFraction = 0.91,
                    CapacityFractionDeviation = 0.05,
                    PlanCharge = 0.4,
                    PlanTime = TimeSpan.FromSeconds(290),
                },
                Result = new MissionResult
                {
                    Outcome = MissionOutcome.Accomplished,
                    HasFlown = true,
                    HasLanded = true,
                    DistanceFromHomeMetres = 0.64
                },
            },
            Group = group,
            GroupRoles = roles ?? [],
            Pictures = MadeUpTargets.Tracks(finds, hasFalseTrack).Where(t => t.BestPictureNumber >= 0)
                .SelectMany(MadeUpTargets.Chips).ToArray(),
            Overviews = MadeUpTargets.Tracks(finds, hasFalseTrack).Where(t => t.Id != MadeUpTargets.FalseTrackId)
                .Select(MadeUpTargets.Overview).ToArray(),
            Vehicle = new VehicleState
            {
                SystemId = 1,
                Mode = "RTL",
                IsConnected = true,
                PositionTime = flight.End,
                Position = MadeUpSite.Frame.ToGeodetic(new NedPosition(0.4, -0.5, 0)),
                BatteryTime = flight.End,
                BatteryRemaining = 0.63,
            },
            Health = new HealthReport { Level = HealthLevel.Good, SendsHeartbeat = true },
            Imaging = new ImagingStatus
            {
                HasCamera = true,
                Frames = 512,
                Observations = flight.Observations.Count,
                FramesRefused = 2,
                Reports = 61
            },
            Tracks = new TrackList(flight.End, MadeUpTargets.Tracks(finds, hasFalseTrack)),
            FlownMetres = 1423,
            ArmedTime = flight.End - TimeSpan.FromSeconds(6),
            MaxHeightAboveHomeMetres = MadeUpSite.HeightMetres,
            FirstBatteryRemaining = 0.98,
        };
    }

    public static FlightSummary Summary(FlightRecord record) => new(record)
    {
        CommandLine = "UavConsole --seed 7 --targets 5",
        Seed = 7,
        Source = "simulated flight, seed 7, 5 targets, mission search.json",
        StopReason = "recorder: the mission is over",
        Mission = new MissionSummary(record, MadeUpTargets.Score(record)),
        Events = Events(),
        EventCount = Events().Length,
        Managers = ManagerNames.Select((name, index) => new ManagerSummary
        {
            Name = name,
            Outcome = "Ended",
            Runs = 1200 + (index * 731),
            MeanWork = TimeSpan.FromTicks(400 + (index * 9_000)),
            LongestWork = TimeSpan.FromMilliseconds(3 + index),
            TotalWork = TimeSpan.FromSeconds(0.4 * (index + 1)),
            Faults = index == 3 ? 1 : 0,
            FirstFault = index == 3
                ? "sensor fusion in UnitOfWork: InvalidOperationException: planted for the picture"
                : null,
        }).ToArray(),
    };

    private static FlightEvent[] Events() =>
    [
        new(
            TimeSpan.Zero, RabitLogKind.Lifecycle, "reactor",
            "starts communications, autopilot, image processing, sensor fusion, mission control, health"),
        new(
            TimeSpan.FromSeconds(1.02), RabitLogKind.Manager, "autopilot",
            "autopilot Ardupilotmega of a Quadrotor, system 1, component 1"),
        new(TimeSpan.FromSeconds(4), RabitLogKind.Manager, "mission control", "arms"),
        new(TimeSpan.FromSeconds(6), RabitLogKind.Manager, "mission control", "takes off to 40 m"),
        new(
            TimeSpan.FromSeconds(62.4), RabitLogKind.Manager, "sensor fusion",
            "track 1 (red) confirmed after 5 reports"),
        new(TimeSpan.FromSeconds(63), RabitLogKind.Manager, "mission control", "leaves lane 1 to revisit track 1"),
        new(
            TimeSpan.FromSeconds(88), RabitLogKind.Fault, "sensor fusion",
            "InvalidOperationException: planted for the picture"),
        new(
            TimeSpan.FromSeconds(90), RabitLogKind.Manager, "autopilot",
            "status text: <script>alert(1)</script> \u001b[31m & \"quoted\" \uD800 \u202Eright to left"),
        new(TimeSpan.FromSeconds(150), RabitLogKind.Manager, "mission control", "all lanes flown: returns"),
    ];
}
