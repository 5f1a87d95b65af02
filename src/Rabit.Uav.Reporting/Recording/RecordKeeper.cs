using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// The lists behind a <see cref="FlightRecord"/>: written by the recorder's thread, read by any thread, under a lock
/// of its own.
/// </summary>
internal sealed class RecordKeeper(
    IReadOnlyList<string> managerNames, Func<IReadOnlyList<ImageChip>> imageChips,
    Func<long, PictureOverview?>? findOverview = null)
{
    // At five a second an hour fits before every second one goes.
    private const int MaxSamples = 20_000;
    private const int MaxObservations = 8_000;
    private const int MaxManagerSamples = 2_000;
    private const int MaxChanges = 2_000;

    // Positions come several times a second.
    private static readonly TimeSpan MaxPositionAge = TimeSpan.FromSeconds(2);

    private readonly object _gate = new();   // guards all below
    private readonly DecimatedSeries<FlightSample> _samples = new(MaxSamples);
    private readonly DecimatedSeries<CameraObservation> _observations = new(MaxObservations);
    private readonly DecimatedSeries<ManagerSample>[] _managers =
        managerNames.Select(_ => new DecimatedSeries<ManagerSample>(MaxManagerSamples)).ToArray();
    private readonly List<PhaseChange> _phases = [];
    private readonly TrackPictures _pictures = new(imageChips, findOverview);
    private readonly List<HealthChange> _healthChanges = [];
    private readonly TelemetryRecorder _telemetry = new();
    private VehicleState _vehicle;
    private AutopilotStatistics _autopilot;
    private long _framesDropped;
    private MissionStatus _mission;
    private HealthReport _health;
    private ImagingStatus _imaging;
    private CommandAuthority _authority;
    private readonly GroupRoles _group = new();
    private readonly MovingTrackMemory _moving = new();
    private TrackList _tracks = TrackList.None;
    private TimeSpan? _last;
    private double _flownMetres;
    private TimeSpan _armedTime;
    private double _maxHeight;
    private double _firstBattery = double.NaN;

    public void Take(
        TimeSpan now,
        in VehicleState vehicle,
        in MissionStatus mission,
        in HealthReport health,
        in ImagingStatus imaging,
        in CommandAuthority authority,
        TrackList tracks,
        in GroupStatus group)
    {
        lock (_gate)
        {
            TimeSpan step = now - (_last ?? now);
            _last = now;
            AddUp(now, step, vehicle);
            NoteChanges(now, mission, health);
            if (imaging.Observations != _imaging.Observations)
                _observations.Add(imaging.LastObservation);
            (_vehicle, _mission, _health) = (vehicle, mission, health);
            (_imaging, _authority, _tracks) = (imaging, authority, _moving.Take(tracks));
            _pictures.Take(tracks);
            _group.Take(now, vehicle.SystemId, group);
            _samples.Add(Sample(now));
        }
    }

    /// <summary>Takes all frames out of the recorder's queue.</summary>
    public void TakeFrames(QueueReceiver<LinkFrame> frames, in VehicleState vehicle, in AutopilotStatistics autopilot)
    {
        lock (_gate)
        {
            _autopilot = autopilot;
            _telemetry.SetVehicle(vehicle.SystemId, vehicle.ComponentId);
            while (frames.TryPop(out LinkFrame frame))
                _telemetry.Record(frame);
            _framesDropped = frames.Counters.Rejected;
        }
    }

    public void TakeManager(int index, TimeSpan now, in ManagerStatus status)
    {
        lock (_gate)
            _managers[index].Add(new ManagerSample(now, status.State, status.Runs, status.Faults));
    }

    public FlightRecord Snapshot()
    {
        lock (_gate)
        {
            return new FlightRecord
            {
                Samples = _samples.ToArray(),
                Observations = _observations.ToArray(),
                Phases = _phases.ToArray(),
                HealthChanges = _healthChanges.ToArray(),
                Managers = _managers.Select((m, index) => new ManagerTimeLine(managerNames[index], m.ToArray()))
                    .ToArray(),
                Telemetry = _telemetry.ToRecord(_framesDropped),
                Autopilot = _autopilot,
                Vehicle = _vehicle,
                Mission = _mission,
                Health = _health,
                Imaging = _imaging,
                Authority = _authority,
                Tracks = _tracks,
                Group = _group.Latest,
                GroupRoles = _group.ToArray(),
                MovingTrackPaths = _moving.Paths,
                Pictures = _pictures.ToArray(),
                Overviews = _pictures.OverviewsToArray(),
                FlownMetres = _flownMetres,
                ArmedTime = _armedTime,
                MaxHeightAboveHomeMetres = _maxHeight,
                FirstBatteryRemaining = _firstBattery,
            };
        }
    }

    // Speed over time, not place to place: the noise of a receiver would make a hovering vehicle travel.
    // Not while nothing is received: the last velocity says nothing then.
    private void AddUp(TimeSpan now, TimeSpan step, in VehicleState vehicle)
    {
        if (double.IsNaN(_firstBattery) && vehicle.BatteryTime is not null)
            _firstBattery = vehicle.BatteryRemaining;
        if (!vehicle.IsArmed)
            return;
        _armedTime += step;
        if (!vehicle.IsConnected || !(now - vehicle.PositionTime <= MaxPositionAge))
            return;
        NedVector v = vehicle.VelocityNed;
        _flownMetres += Math.Sqrt((v.North * v.North) + (v.East * v.East) + (v.Down * v.Down)) * step.TotalSeconds;
        _maxHeight = Math.Max(_maxHeight, vehicle.HeightAboveHomeMetres);
    }

    private void NoteChanges(TimeSpan now, in MissionStatus mission, in HealthReport health)
    {
        bool isNewPhase = mission.Phase != _mission.Phase || mission.Since != _mission.Since;
        if (isNewPhase && _phases.Count < MaxChanges)
            _phases.Add(new PhaseChange(mission.Since, mission.Phase, mission.Text));
        bool isNewHealth = health.Level != _health.Level || health.Reasons != _health.Reasons
            || health.Advice != _health.Advice;
        if (isNewHealth && _healthChanges.Count < MaxChanges)
            _healthChanges.Add(new HealthChange(now, health));
    }

    private FlightSample Sample(TimeSpan now) => new()
    {
        Time = now,
        HasPosition = _vehicle.PositionTime is not null,
        Position = _vehicle.Position,
        HeightAboveHomeMetres = _vehicle.HeightAboveHomeMetres,
        GroundSpeed = Math.Sqrt(
            (_vehicle.VelocityNed.North * _vehicle.VelocityNed.North)
                + (_vehicle.VelocityNed.East * _vehicle.VelocityNed.East)),
        Yaw = _vehicle.Attitude.Yaw,
        BatteryRemaining = _vehicle.BatteryTime is null ? double.NaN : _vehicle.BatteryRemaining,
        ChargeLeft = _mission.Energy.IsKnown ? _mission.Energy.ChargeLeft : double.NaN,
        ChargeNeeded = _mission.Energy.IsKnown ? _mission.Energy.ChargeHome + _mission.Energy.Reserve : double.NaN,
        Phase = _mission.Phase,
        Coverage = _mission.Coverage,
        Health = _health.Level,
    };
}
