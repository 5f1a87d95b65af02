using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Reporting;

namespace Rabit.Uav.Simulation.Tests.Group;

/// <summary>
/// One or several vehicles search 24 ha with ten standing targets, and how long what of it takes. What was seen is
/// counted here, by the same rule for any number of vehicles.
/// </summary>
internal sealed class CoverageFlight : IDisposable
{
    /// <summary>600 by 400 m, flown at 8 m/s; home is beside a corner.</summary>
    public const string Mission =
        """
        {
          "name": "24 ha",
          "area": [[47.397300, 8.544600], [47.400898, 8.544600], [47.400898, 8.552557], [47.397300, 8.552557]],
          "allowPartialSearch": true, "heightMetres": 36, "speedMetresPerSecond": 8, "laneSpacingMetres": 30,
          "targets": ["red", "orange", "blue", "yellow", "magenta"],
          "home": { "latitudeDegrees": 47.397100, "longitudeDegrees": 8.544300, "groundAltitudeAmslMetres": 488 }
        }
        """;

    // So that one vehicle searches all of it without a landing.
    private const double PackMilliampereHours = 12_000;

    private const int StepsPerSample = 5;
    private const double CellMetres = 2;
    private const double NewGroundSeconds = 2;

    // Two vehicles locate one target as differently as that, but seldom.
    private const double SameMetres = 10;

    private readonly GroupFlight _flight;
    private readonly int _vehicles;
    private readonly LocalNedFrame _frame;
    private readonly double _north;
    private readonly double _east;
    private readonly bool[] _isSeen;
    private readonly int _rows;
    private readonly int _columns;
    private readonly List<MessageSubscriber<ImagingStatus>> _pictures = [];
    private readonly long[] _lastPicture;
    private readonly List<MessageSubscriber<VehicleState>> _states = [];
    private readonly List<(double Seconds, double Fraction)> _coverage = [];
    private readonly double[] _lastNew;
    private readonly Activity?[] _activities;
    private int _seen;

    public CoverageFlight(
        int vehicles, long seed, SimulatedCameraOptions? camera = null, bool revisits = true,
        SimulatedRadioOptions? radio = null, params SimulatedGroupFault[] faults)
    {
        _vehicles = vehicles;
        MissionPlan plan = MissionPlan.Parse(
            revisits
                ? Mission
                : Mission.Replace("\"targets\"", "\"revisit\": { \"enabled\": false }, \"targets\""),
            "24 ha");
        var world = new SimulationOptions { Seed = seed, TargetCount = 10, DistractorCount = 6 };
        world.Parameters = new Dictionary<string, double>(StringComparer.Ordinal)
        {
            ["BATT_CAPACITY"] = PackMilliampereHours,
        };
        if (camera is not null)
            world.Camera = camera;
        _frame = LocalNedFrame.IgnoringGeoid(plan.Area[0]);
        NedPosition corner = _frame.ToNed(plan.Area[2]);
        (_north, _east) = (corner.North, corner.East);
        (_rows, _columns) = ((int)(_north / CellMetres), (int)(_east / CellMetres));
        _isSeen = new bool[_rows * _columns];
        (_lastNew, _lastPicture) = (new double[vehicles], new long[vehicles]);
        _activities = new Activity?[vehicles];
        Spans = Enumerable.Range(0, vehicles).Select(_ => new List<Activity>()).ToArray();
        _flight = new GroupFlight(
            plan,
            new SimulatedGroupOptions
            {
                Vehicles = vehicles,
                World = world,
                Radio = radio ?? new SimulatedRadioOptions(),
                Faults = faults,
            },
            layerSpacingMetres: 19, wire: Wire, isGroup: vehicles > 1);
    }

    /// <summary>What each vehicle did, in their order.</summary>
    public List<Activity>[] Spans { get; }

    public GroupFlight Flight => _flight;

    /// <summary>Called ten times in a second of the flight, to watch it.</summary>
    public Action Stepped { get; set; } = () => { };

    public double TakeOffSeconds { get; private set; } = double.NaN;

    public double LandedSeconds { get; private set; } = double.NaN;

    public double Fraction => _coverage.Count == 0 ? 0 : _coverage[_coverage.Count - 1].Fraction;

    /// <summary>How many of the targets are confirmed tracks of each vehicle, at the least.</summary>
    public int Found => Scores().Min(s => s.Found);

    /// <summary>How many of the targets are confirmed tracks of at least one vehicle.</summary>
    public int FoundByAny
        => Scores().SelectMany(s => s.Targets.Where(t => t.IsFound)).Select(t => t.Name).Distinct().Count();

    /// <summary>
    /// How many confirmed tracks are no target, of the vehicle with the most; without those that a second vehicle
    /// rejected when it was asked, which is what it is asked for.
    /// </summary>
    public int FalseTracks => Scores().Max(s => s.FalseTracks.Count(t => !IsRejected(t)));

    /// <summary>How many of what one vehicle took for a target a second one rejected.</summary>
    public int Rejected => Validations(ValidationResult.Rejected).Count();

    /// <summary>What a second vehicle confirmed; of one vehicle what it revisited.</summary>
    public int Confirmed => _vehicles == 1
        ? _flight.Mission(0).Revisits
        : Validations(ValidationResult.Confirmed).Count();

    private IEnumerable<ValidationTask> Validations(ValidationResult result) => Enumerable.Range(0, _vehicles)
        .SelectMany(i => _flight.GroupStatus(i).Validations.Where(t => t.Finder == i + 1))
        .Where(t => t.Result == result && t.Validator != t.Finder);

    private bool IsRejected(TargetTrack track) => Validations(ValidationResult.Rejected).Any(
        t => t.Class == track.Class && (_frame.ToNed(t.Position) - _frame.ToNed(track.Position)).Length < SameMetres);

    private MissionScore[] Scores()
    {
        TargetTruth truth = TargetTruth.Of(_flight.Group.Vehicles[0].World);
        return Enumerable.Range(0, _vehicles).Select(i => TargetScoring.Score(truth, _flight.Tracks(i).Tracks))
            .ToArray();
    }

    /// <summary>From the first take-off to the last landing.</summary>
    public double Seconds => LandedSeconds - TakeOffSeconds;

    /// <summary>From the first take-off until so much was seen; not a number where it never was.</summary>
    public double SecondsTo(double fraction)
    {
        foreach ((double seconds, double seen) in _coverage)
        {
            if (seen >= fraction)
                return seconds - TakeOffSeconds;
        }

        return double.NaN;
    }

    /// <returns>Whether all have landed.</returns>
    public bool Fly(double maxSeconds = 2400)
    {
        bool isOver = false;
        while (!isOver && _flight.Group.Now.TotalSeconds < maxSeconds)
        {
            for (int i = 0; i < StepsPerSample; i++)
                _flight.Group.Step();
            isOver = Sample();
            Stepped();
        }

        for (int i = 0; i < _vehicles; i++)
            Begin(i, string.Empty);
        return isOver;
    }

    /// <summary>How long each vehicle did what.</summary>
    public string Totals()
    {
        var text = new StringBuilder();
        for (int i = 0; i < _vehicles; i++)
        {
            text.Append(FormattableString.Invariant($"vehicle {i + 1}:"));
            foreach (IGrouping<string, Activity> what in Spans[i].GroupBy(s => s.What))
                text.Append(FormattableString.Invariant($"  {what.Key} {what.Sum(s => s.To - s.From):0}"));
            text.AppendLine();
        }

        return text.ToString();
    }

    public string Timeline()
    {
        var text = new StringBuilder();
        for (int i = 0; i < _vehicles; i++)
        {
            text.AppendLine(FormattableString.Invariant($"vehicle {i + 1}"));
            foreach (Activity s in Spans[i])
            {
                text.AppendLine(FormattableString.Invariant(
                    $"  {s.From - TakeOffSeconds,7:0.0} {s.To - s.From,6:0.0} s  {s.What,-12} {s.At}"));
            }
        }

        return text.ToString();
    }

    public void Dispose() => _flight.Dispose();

    private void Wire(int vehicle, RabitReactor reactor)
    {
        _pictures.Add(reactor.Workspace.Subscribe<ImagingStatus>(MessageNames.Imaging));
        _states.Add(reactor.Workspace.Subscribe<VehicleState>(MessageNames.VehicleState));
    }

    private bool Sample()
    {
        double now = _flight.Group.Now.TotalSeconds;
        bool isOver = true;
        for (int i = 0; i < _vehicles; i++)
        {
            _pictures[i].Fetch();
            CameraObservation picture = _pictures[i].Value.LastObservation;
            if (picture.Number != _lastPicture[i] && Mark(picture) > 2)
                _lastNew[i] = now;
            _lastPicture[i] = picture.Number;

            _states[i].Fetch();
            MissionStatus mission = _flight.Mission(i);
            bool isArmed = _states[i].Value.IsArmed;
            if (isArmed && double.IsNaN(TakeOffSeconds))
                TakeOffSeconds = now;
            if (isArmed)
                LandedSeconds = now;
            isOver &= _flight.Group.Vehicles[i].IsLost
                || mission.Phase is MissionPhase.Done or MissionPhase.Failed or MissionPhase.HandedOver;
            Begin(i, WhatOf(mission, now - _lastNew[i]));
        }

        _coverage.Add((now, (double)_seen / _isSeen.Length));
        return isOver;
    }

    private static string WhatOf(in MissionStatus mission, double secondsSinceNew) => mission.Phase switch
    {
        MissionPhase.Searching when mission.Text?.StartsWith("our ", StringComparison.Ordinal) == true => "waiting",
        MissionPhase.Searching when secondsSinceNew > NewGroundSeconds => "nothing new",
        MissionPhase.Searching => "new ground",
        _ => mission.Phase.ToString(),
    };

    private void Begin(int vehicle, string what)
    {
        double now = _flight.Group.Now.TotalSeconds;
        if (_activities[vehicle] is { } last)
        {
            if (last.What == what)
                return;
            Spans[vehicle].Add(last with { To = now });
        }

        NedPosition at = _frame.ToNed(_states[vehicle].Value.Position);
        _activities[vehicle] = new Activity(
            what, now, now,
            FormattableString.Invariant($"at {at.North:0}, {at.East:0}, {_flight.Mission(vehicle).Text}"));
    }

    private int Mark(in CameraObservation picture)
    {
        var ground = new GroundPolygon(
            new[] { picture.TopLeft, picture.TopRight, picture.BottomRight, picture.BottomLeft }
                .Select(c => _frame.ToNed(c)).Select(n => (n.North, n.East)).ToArray(),
            nameof(picture));
        int before = _seen;
        int firstRow = Cell(ground.South, _rows);
        int lastRow = Cell(ground.North, _rows);
        int firstColumn = Cell(ground.West, _columns);
        int lastColumn = Cell(ground.East, _columns);
        for (int row = firstRow; row <= lastRow; row++)
        {
            for (int column = firstColumn; column <= lastColumn; column++)
            {
                int cell = (row * _columns) + column;
                if (_isSeen[cell] || !ground.Contains((row + 0.5) * CellMetres, (column + 0.5) * CellMetres))
                    continue;
                _isSeen[cell] = true;
                _seen++;
            }
        }

        return _seen - before;
    }

    private static int Cell(double metres, int count)
        => Math.Max(0, Math.Min(count - 1, (int)Math.Floor(metres / CellMetres)));

    /// <summary>What a vehicle did for a while.</summary>
    internal readonly record struct Activity(string What, double From, double To, string At);
}
