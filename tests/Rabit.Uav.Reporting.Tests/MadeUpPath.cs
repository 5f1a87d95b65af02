using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using static Rabit.Uav.Reporting.Tests.MadeUpSite;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>
/// The path of the made-up flight: lanes over the area with two revisits, and what the managers did meanwhile.
/// </summary>
internal sealed class MadeUpPath
{
    private readonly List<FlightSample> _samples = [];
    private readonly List<CameraObservation> _observations = [];
    private readonly List<PhaseChange> _phases = [];
    private readonly Random _random = new(4);   // of the tests alone; the picture may change with the runtime
    private double _time;
    private NedPosition _at;

    public MadeUpPath() => Fly();

    /// <summary>When the flight is over.</summary>
    public TimeSpan End => TimeSpan.FromSeconds(_time);

    public IReadOnlyList<FlightSample> Samples => _samples;

    public IReadOnlyList<CameraObservation> Observations => _observations;

    public IReadOnlyList<PhaseChange> Phases => _phases;

    public ManagerTimeLine TimeLine(string name)
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

    private void Fly()
    {
        Wait(MissionPhase.WaitingForVehicle, 4);
        Wait(MissionPhase.Arming, 2);
        Begin(MissionPhase.TakingOff);
        Go(new NedPosition(0, 0, -HeightMetres), 2.5, MissionPhase.TakingOff);
        Begin(MissionPhase.InTransit);
        for (int lane = 0; lane < LaneNorths.Count; lane++)
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

    private double Gauss()
        => Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())) * Math.Cos(2 * Math.PI * _random.NextDouble());
}
