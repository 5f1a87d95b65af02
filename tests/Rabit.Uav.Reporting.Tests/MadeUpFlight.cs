using System;
using System.Collections.Generic;
using System.Collections.Immutable;
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
internal sealed class MadeUpFlight
{
    private const int FalseTrackId = 8;
    private const double HeightMetres = 40;
    private const double Speed = 6;
    private static readonly NedPosition[] Area = [new(20, 20, 0), new(140, 20, 0), new(140, 180, 0), new(20, 180, 0)];
    private static readonly double[] LaneNorths = [35, 65, 95, 125];
    private static readonly string[] ManagerNames =
    [
        "communications", "autopilot", "image processing", "sensor fusion", "mission control", "health",
        "simulated vehicle", "recorder"
    ];

    private readonly List<FlightSample> _samples = [];
    private readonly List<CameraObservation> _observations = [];
    private readonly List<PhaseChange> _phases = [];
    private readonly Random _random = new(4);   // of the tests alone; the picture may change with the runtime
    private double _time;
    private NedPosition _at;

    private MadeUpFlight() => Fly();

    public static GeodeticPosition Home { get; } = GeodeticPosition.FromDegrees(47.39697, 8.54426, 488);

    public static LocalNedFrame Frame { get; } = LocalNedFrame.IgnoringGeoid(Home);

    public static IReadOnlyList<TargetScore> Targets { get; } =
    [
        Target("T1", DefaultTargetClasses.Red, 48, 60),
        Target("T2", DefaultTargetClasses.Orange, 76, 131),
        Target("T3", DefaultTargetClasses.Blue, 104, 41),
        Target("T4", DefaultTargetClasses.Yellow, 121, 152),
        Target("T5", DefaultTargetClasses.Magenta, 33, 166),
    ];

    public static SearchPlan Plan { get; } = new()
    {
        Name = "search of a meadow",
        Home = Home,
        Area = [.. Area.Select(Frame.ToGeodetic)],
        Fence =
        [
            .. new[]
            {
                new NedPosition(-15, -15, 0),
                new NedPosition(160, -15, 0),
                new NedPosition(160, 200, 0),
                new NedPosition(-15, 200, 0)
            }
                .Select(Frame.ToGeodetic)
        ],
        Lanes =
        [
            .. LaneNorths.SelectMany((n, i) => i % 2 == 0 ? new[] { (n, 20.0), (n, 180.0) } : [(n, 180.0), (n, 20.0)])
                .Select(p => Frame.ToGeodetic(new NedPosition(p.Item1, p.Item2, -HeightMetres)))
        ],
        HeightAboveHomeMetres = HeightMetres,
        SpeedMetresPerSecond = Speed,
    };

    /// <param name="finds">How many of the five targets are found.</param>
    /// <param name="hasFalseTrack">Whether a track is confirmed where there is nothing.</param>
    public static FlightRecord Record(int finds = 5, bool hasFalseTrack = false)
    {
        var flight = new MadeUpFlight();
        return new FlightRecord
        {
            Samples = flight._samples,
            Observations = flight._observations,
            Phases = flight._phases,
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
                Plan = Plan,
                Coverage = 0.993,
                LanesFlown = 4,
                Revisits = finds,
                Text = "landed",
                Result = new MissionResult
                {
                    Outcome = MissionOutcome.Accomplished,
                    HasFlown = true,
                    HasLanded = true,
                    DistanceFromHomeMetres = 0.64
                },
            },
            Pictures = Tracks(finds, hasFalseTrack).Where(t => t.BestPictureNumber >= 0).Select(Chip).ToArray(),
            Vehicle = new VehicleState
            {
                SystemId = 1,
                Mode = "RTL",
                IsConnected = true,
                PositionTime = TimeSpan.FromSeconds(flight._time),
                Position = Frame.ToGeodetic(new NedPosition(0.4, -0.5, 0)),
                BatteryTime = TimeSpan.FromSeconds(flight._time),
                BatteryRemaining = 0.63,
            },
            Health = new HealthReport { Level = HealthLevel.Good, SendsHeartbeat = true },
            Imaging = new ImagingStatus
            {
                HasCamera = true,
                Frames = 512,
                Observations = flight._observations.Count,
                FramesRefused = 2,
                Reports = 61
            },
            Tracks = new TrackList(TimeSpan.FromSeconds(flight._time), Tracks(finds, hasFalseTrack)),
            FlownMetres = 1423,
            ArmedTime = TimeSpan.FromSeconds(flight._time - 6),
            MaxHeightAboveHomeMetres = HeightMetres,
            FirstBatteryRemaining = 0.98,
        };
    }

    /// <summary>Compared with the truth: each target has the track of its colour.</summary>
    public static MissionScore Score(FlightRecord record)
    {
        TargetTrack[] confirmed = record.Tracks.Confirmed.ToArray();
        TargetScore[] targets =
        [
            .. Targets.Select(t => Found(t, confirmed.FirstOrDefault(c => c.Class == t.Class && c.Id != FalseTrackId)))
        ];
        return new MissionScore { Targets = targets, FalseTracks = [.. confirmed.Where(t => t.Id == FalseTrackId)] };
    }

    public static FlightSummary Summary(FlightRecord record) => new(record)
    {
        CommandLine = "UavConsole --seed 7 --targets 5",
        Seed = 7,
        Source = "simulated flight, seed 7, 5 targets, mission search.json",
        StopReason = "recorder: the mission is over",
        Mission = new MissionSummary(record, Score(record)),
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

    private static TargetScore Target(string name, TargetClassName targetClass, double north, double east)
        => new() { Name = name, Class = targetClass, Position = Frame.ToGeodetic(new NedPosition(north, east, 0)) };

    private static TargetScore Found(TargetScore target, TargetTrack? track)
    {
        NedPosition error = track is null
            ? default
            : LocalNedFrame.IgnoringGeoid(target.Position).ToNed(track.Position);
        return new TargetScore
        {
            Name = target.Name,
            Class = target.Class,
            Position = target.Position,
            Track = track,
            ErrorNorthMetres = error.North,
            ErrorEastMetres = error.East,
        };
    }

    private static IEnumerable<TargetTrack> Tracks(int finds, bool hasFalseTrack)
    {
        (double N, double E)[] errors = [(0.6, -0.5), (-0.3, 0.8), (1.1, 0.2), (-0.4, -0.9), (0.2, 0.7)];
        for (int index = 0; index < finds; index++)
        {
            NedPosition truth = Frame.ToNed(Targets[index].Position);
            yield return Track(
                index + 1, Targets[index].Class, TrackState.Confirmed, truth.North + errors[index].N,
                truth.East + errors[index].E);
        }

        if (hasFalseTrack)
            yield return Track(FalseTrackId, DefaultTargetClasses.Red, TrackState.Confirmed, 88, 92);
        yield return Track(9, DefaultTargetClasses.Orange, TrackState.Tentative, 60, 100);
    }

    private static TargetTrack Track(int id, TargetClassName colour, TrackState state, double north, double east)
        => new()
        {
            Id = id,
            Class = colour,
            State = state,
            Position = Frame.ToGeodetic(new NedPosition(north, east, 0)),
            Covariance = new HorizontalCovariance(1.1, 0.3, 0.8),
            Reports = 12 + id,
            Misses = id % 3,
            SizeMetres = 1.02,
            FirstSeen = TimeSpan.FromSeconds(40 + (15 * id)),
            LastSeen = TimeSpan.FromSeconds(60 + (18 * id)),
            BestPictureNumber = 100 + id,
            BestReportIndex = 0,
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

    private static ImageChip Chip(TargetTrack track)
    {
        const int Size = 48;
        var rgb = new byte[Size * Size * 3];
        uint css = track.Class == DefaultTargetClasses.Red ? 0xCD1C20u : 0x1C48CDu;
        var random = new Random(track.Id);
        for (int index = 0; index < Size * Size; index++)
        {
            bool isTarget = Math.Abs((index % Size) - 24) < 7 && Math.Abs((index / Size) - 24) < 7;
            int noise = random.Next(-18, 18);
            for (int channel = 0; channel < 3; channel++)
            {
                int ground = new[] { 96, 118, 74 }[channel];
                int value = isTarget ? (int)((css >> (16 - (8 * channel))) & 255) : ground;
                rgb[(index * 3) + channel] = (byte)Math.Max(0, Math.Min(255, value + noise));
            }
        }

        return new ImageChip(track.BestPictureNumber, track.BestReportIndex, Size, Size, rgb);
    }

    private void Fly()
    {
        Wait(MissionPhase.WaitingForVehicle, 4);
        Wait(MissionPhase.Arming, 2);
        Begin(MissionPhase.TakingOff);
        Go(new NedPosition(0, 0, -HeightMetres), 2.5, MissionPhase.TakingOff);
        Begin(MissionPhase.InTransit);
        for (int lane = 0; lane < LaneNorths.Length; lane++)
        {
            bool isEastward = lane % 2 == 0;
            Go(
                new NedPosition(LaneNorths[lane], isEastward ? 20 : 180, -HeightMetres), Speed,
                lane == 0 ? MissionPhase.InTransit : MissionPhase.Searching);
            Begin(MissionPhase.Searching);
            Go(new NedPosition(LaneNorths[lane], isEastward ? 110 : 90, -HeightMetres), Speed, MissionPhase.Searching);
            if (lane is 0 or 2)
            {
                NedPosition back = _at;
                Begin(MissionPhase.Revisiting);
                Go(new NedPosition(LaneNorths[lane] + 14, back.East - 18, -HeightMetres), 4, MissionPhase.Revisiting);
                Wait(MissionPhase.Revisiting, 5);
                Go(back, 4, MissionPhase.Revisiting);
                Begin(MissionPhase.Searching);
            }

            Go(new NedPosition(LaneNorths[lane], isEastward ? 180 : 20, -HeightMetres), Speed, MissionPhase.Searching);
        }

        Begin(MissionPhase.Returning);
        Go(new NedPosition(0.4, -0.5, -HeightMetres), 8, MissionPhase.Returning);
        Begin(MissionPhase.Landing);
        Go(new NedPosition(0.4, -0.5, 0), 1.5, MissionPhase.Landing);
        Begin(MissionPhase.Done);
        Wait(MissionPhase.Done, 3);
    }

    private void Begin(MissionPhase phase)
        => _phases.Add(new PhaseChange(TimeSpan.FromSeconds(_time), phase, phase.ToString()));

    private void Wait(MissionPhase phase, double seconds)
    {
        for (double end = _time + seconds; _time < end;)
            Sample(phase, 0, 0);
    }

    private void Go(NedPosition to, double speed, MissionPhase phase)
    {
        while (true)
        {
            (double n, double e, double d) = (to.North - _at.North, to.East - _at.East, to.Down - _at.Down);
            double left = Math.Sqrt((n * n) + (e * e) + (d * d));
            double step = Math.Min(left, speed * 0.2);
            if (left < 1e-6)
                return;
            _at = new NedPosition(
                _at.North + (n * step / left), _at.East + (e * step / left), _at.Down + (d * step / left));
            Sample(phase, Math.Sqrt((n * n) + (e * e)) / left * speed, Math.Atan2(e, n));
        }
    }

    private void Sample(MissionPhase phase, double speed, double yaw)
    {
        bool isLooking = phase is MissionPhase.Searching or MissionPhase.Revisiting;
        double coverage = Math.Min(0.993, _observations.Count / 300.0);
        _samples.Add(new FlightSample
        {
            Time = TimeSpan.FromSeconds(_time),
            HasPosition = _time > 1,
            Position = Frame.ToGeodetic(
                new NedPosition(_at.North + (0.3 * Gauss()), _at.East + (0.3 * Gauss()), _at.Down)),
            HeightAboveHomeMetres = -_at.Down + (0.2 * Gauss()),
            GroundSpeed = Math.Max(0, speed + (0.15 * Gauss())),
            Yaw = Angle.FromRadians(yaw),
            BatteryRemaining = _time < 1 ? double.NaN : 0.98 - (_time * 0.0018),
            Phase = phase,
            Coverage = coverage,
            Health = _time < 1.5 ? HealthLevel.Warning
                : _time is > 88 and < 96 ? HealthLevel.Warning
                : HealthLevel.Good,
        });
        if (isLooking && _samples.Count % 3 == 0)
            _observations.Add(Observe(yaw));
        _time += 0.2;
    }

    private CameraObservation Observe(double yaw)
    {
        (double forward, double right) = (HeightMetres * 240 / 530, HeightMetres * 320 / 530);
        GeodeticPosition Corner(double f, double r) => Frame.ToGeodetic(new NedPosition(
            _at.North + (f * Math.Cos(yaw)) - (r * Math.Sin(yaw)), _at.East + (f * Math.Sin(yaw)) + (r * Math.Cos(yaw)),
            0));
        return new CameraObservation
        {
            Number = _observations.Count,
            Time = TimeSpan.FromSeconds(_time),
            TopLeft = Corner(forward, -right),
            TopRight = Corner(forward, right),
            BottomRight = Corner(-forward, right),
            BottomLeft = Corner(-forward, -right),
        };
    }

    private ManagerTimeLine TimeLine(string name)
    {
        var samples = new List<ManagerSample>();
        long runs = 0;
        for (double t = 0; t < _time; t += 2)
        {
            bool isFault = name == "sensor fusion" && t >= 88;
            samples.Add(new ManagerSample(
                TimeSpan.FromSeconds(t), t is >= 88 and < 90 && isFault ? ManagerState.Faulted : ManagerState.Running,
                runs, isFault ? 1 : 0));
            runs += name switch
            {
                "image processing" or "sensor fusion" => t is > 30 and < 170 ? 4 + _random.Next(3) : 0,
                "communications" or "autopilot" => 60 + _random.Next(40),
                "simulated vehicle" => 200,
                _ => 8 + _random.Next(4),
            };
        }

        return new ManagerTimeLine(name, samples);
    }

    private double Gauss()
        => Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())) * Math.Cos(2 * Math.PI * _random.NextDouble());
}
