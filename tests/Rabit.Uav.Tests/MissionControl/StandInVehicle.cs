using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>
/// Stands in for Autopilot Interface, Image Processing, Sensor Fusion and Health Monitoring: a point that flies as
/// commanded, a camera that sees the ground below it, and the faults that a test injects. No MAVLink.
/// </summary>
internal sealed partial class StandInVehicle : RabitManager
{
    private const double Step = 0.05;
    private const double Acceleration = 2.5;

    private readonly QueueReceiver<VehicleCommand> _commands;
    private readonly QueueReceiver<TrackDecision> _decisions;
    private readonly QueueSender<VehicleCommandResult> _results;
    private readonly QueueSender<CameraObservation> _searched;
    private readonly MessagePublisher<VehicleState> _vehicle;
    private readonly MessagePublisher<HealthReport> _health;
    private readonly MessagePublisher<CommandAuthority> _authority;
    private readonly MessagePublisher<ImagingStatus> _imaging;
    private readonly MessagePublisher<TrackList> _tracks;
    private readonly MessageSubscriber<ImagingCommand> _imagingCommand;
    private readonly LocalNedFrame _frame;
    private VehicleCommand _task;
    private TimeSpan _nextPicture;
    private TimeSpan _nextPost;
    private TimeSpan? _stillSince;
    private TimeSpan _lastHeartbeat;
    private double _vn;
    private double _ve;
    private double _vd;
    private long _picture;

    public StandInVehicle(GeodeticPosition home)
        : base("stand-in")
    {
        _frame = LocalNedFrame.IgnoringGeoid(home);
        _commands = Receive<VehicleCommand>(MessageNames.VehicleCommands);
        _decisions = Receive<TrackDecision>(MessageNames.TrackDecisions);
        _results = Send<VehicleCommandResult>(MessageNames.VehicleCommandResults);
        _searched = Send<CameraObservation>(MessageNames.SearchedGround);
        _vehicle = Publish<VehicleState>(MessageNames.VehicleState);
        _health = Publish<HealthReport>(MessageNames.Health);
        _authority = Publish<CommandAuthority>(MessageNames.CommandAuthority);
        _imaging = Publish<ImagingStatus>(MessageNames.Imaging);
        _tracks = Publish(MessageNames.Tracks, TrackList.None);
        _imagingCommand = Subscribe<ImagingCommand>(MessageNames.ImagingCommand);
        WakeUpDelay = TimeSpan.FromSeconds(Step);
    }

    public double North { get; set; }

    public double East { get; set; }

    /// <summary>Above home.</summary>
    public double Height { get; set; }

    /// <summary>Ground above home at a place, which its camera sees from its height above it.</summary>
    public Func<double, double, double> Ground { get; set; } = (_, _) => 0;

    public double Yaw { get; private set; }

    /// <summary>Motors that stop in the air leave it hanging there: falling is not what is tested.</summary>
    public bool IsArmed { get; set; }

    /// <summary>The motors give no thrust: it falls, and is disarmed 2 s after it met the ground.</summary>
    public bool Falls { get; set; }

    public bool IsConnected { get; set; } = true;

    public bool HasPosition { get; set; } = true;

    /// <summary>Whether the estimator counts on its horizontal position.</summary>
    public bool HasValidPosition { get; set; } = true;

    public bool HasCamera { get; set; } = true;

    public bool CanMove { get; set; } = true;

    public double MaxSpeed { get; set; } = 100;

    public bool CanClimb { get; set; } = true;

    public bool CameraSees { get; set; } = true;

    public bool DisarmsItself { get; set; } = true;

    public bool ReportsLandedState { get; set; } = true;

    public double Battery { get; set; } = 0.9;

    /// <summary>How much higher it is by its satellite receiver; null where that says nothing.</summary>
    public double? GnssAboveMetres { get; set; }

    /// <summary>What else is reported; null for nothing.</summary>
    public Describer? More { get; set; }

    public delegate void Describer(ref VehicleState state);

    public GpsFixType Fix { get; set; } = GpsFixType.Type3dFix;

    /// <summary>Autopilot Interface hangs: nothing is taken and nothing posted; the vehicle flies on.</summary>
    public bool Hangs { get; set; }

    /// <summary>Health Monitoring hangs: nothing is posted.</summary>
    public bool HealthHangs { get; set; }

    public MavState SystemStatus { get; set; } = MavState.Active;

    public List<(TimeSpan Time, VehicleCommand Command)> Renewals { get; } = [];

    public HealthReport Health { get; set; } = new() { Level = HealthLevel.Good };

    public CommandAuthority Authority { get; set; } = new() { State = CommandAuthorityState.Free };

    /// <summary>Answers instead of obeying; null obeys.</summary>
    public Func<VehicleCommand, VehicleCommandOutcome?> Refuses { get; set; } = static _ => null;

    public List<(double North, double East, TargetClassName Colour)> Targets { get; } = [];

    public List<TargetTrack> Tracks { get; } = [];

    /// <summary>What the operator said, by track.</summary>
    public Dictionary<int, TargetDecision> Decisions { get; } = [];

    public bool IgnoresDecisions { get; set; }

    public List<(TimeSpan Time, VehicleCommand Command)> Commands { get; } = [];

    public List<(double North, double East, double Height)> Path { get; } = [];

    public List<CameraObservation> Observations { get; } = [];

    public ImagingCommand Imaging { get; private set; }

    /// <summary>The pilot takes another mode, or something else takes the command.</summary>
    public void TakeOver(string by, TakeoverCause cause = TakeoverCause.Mode)
    {
        Authority = new CommandAuthority { State = CommandAuthorityState.TakenAway, TakenBy = by, Cause = cause };
        _task = new VehicleCommand { Kind = VehicleCommandKind.Hold };
    }

    /// <summary>Another mode was taken and given back: the vehicle holds, and it was not reported.</summary>
    public void ForgetTask() => _task = new VehicleCommand { Kind = VehicleCommandKind.Hold };

    public int Count(VehicleCommandKind kind) => Commands.Count(c => c.Command.Kind == kind);

    protected override void ExecuteUnitOfWork()
    {
        while (!Hangs && _commands.TryPop(out VehicleCommand command))
        {
            if (Commands.FindLastIndex(c => c.Command.Id == command.Id) >= 0)
            {
                Renewals.Add((Now, command));
                continue;
            }

            Commands.Add((Now, command));
            if (IsConnected)
                Answer(command);
        }

        while (_decisions.TryPop(out TrackDecision decision))
            Decide(decision);
        Move();
        Path.Add((North, East, Height));
        TakePicture();
        if (Now >= _nextPost)
            Post();
    }

    private void Answer(VehicleCommand command)
    {
        VehicleCommandOutcome? refusal = Authority.State switch
        {
            _ when command.Kind == VehicleCommandKind.TakeControl => Refuses(command),
            CommandAuthorityState.TakenAway or CommandAuthorityState.Observing => VehicleCommandOutcome.NotInCommand,
            _ => Refuses(command),
        };
        _results.Push(new VehicleCommandResult
        {
            Id = command.Id,
            Kind = command.Kind,
            Outcome = refusal ?? VehicleCommandOutcome.Accepted,
            Text = refusal is null ? null : "because the test says so",
        });
        if (refusal is not null)
            return;
        Authority = new CommandAuthority { State = CommandAuthorityState.Ours };
        if (command.Kind == VehicleCommandKind.Arm)
            IsArmed = true;
        else if (command.Kind == VehicleCommandKind.Disarm)
            IsArmed = Height > 0.1 && IsArmed;
        else if (command.Kind is not (VehicleCommandKind.PointCamera or VehicleCommandKind.TakeControl))
            _task = command;
    }

    private void Move()
    {
        if (!IsArmed)
        {
            (_vn, _ve, _vd) = (0, 0, 0);
            return;
        }

        if (Falls)
        {
            Fall();
            return;
        }

        (double n, double e, double height, double speed) = Goal();
        double sinkOrClimb = CanClimb ? Math.Max(-1.5, Math.Min(2.5, height - Height)) : 0;
        Height = Math.Max(0, Height + (sinkOrClimb * Step));
        _vd = -sinkOrClimb;
        double distance = Math.Sqrt(((n - North) * (n - North)) + ((e - East) * (e - East)));
        double wanted = CanMove ? Math.Min(Math.Min(speed, MaxSpeed), Math.Sqrt(2 * Acceleration * distance) * 0.8) : 0;
        (double wn, double we) = distance < 0.05
            ? (0, 0)
            : (wanted * (n - North) / distance, wanted * (e - East) / distance);
        _vn += Math.Max(-Acceleration * Step, Math.Min(Acceleration * Step, wn - _vn));
        _ve += Math.Max(-Acceleration * Step, Math.Min(Acceleration * Step, we - _ve));
        North += _vn * Step;
        East += _ve * Step;
        StopMotorsOnGround();
    }

    private void Fall()
    {
        _vd = Height > 0 ? _vd + (9.81 * Step) : 0;
        Height = Math.Max(0, Height - (_vd * Step));
        StopMotorsOnGround();
    }

    private void StopMotorsOnGround()
    {
        bool isDown = Height < 0.05 && (Falls || _task.Kind is VehicleCommandKind.Land or VehicleCommandKind.Return);
        _stillSince = isDown ? _stillSince ?? Now : null;
        if (DisarmsItself && Now - _stillSince > TimeSpan.FromSeconds(2))
            IsArmed = false;
    }

    private (double North, double East, double Height, double Speed) Goal()
    {
        switch (_task.Kind)
        {
            case VehicleCommandKind.TakeOff:
                return (North, East, _task.HeightAboveHomeMetres, 0);
            case VehicleCommandKind.GoTo:
                NedPosition to = _frame.ToNed(
                    GeodeticPosition.FromRadians(
                        _task.Latitude.Radians, _task.Longitude.Radians, _frame.Origin.AltitudeAmslMetres));
                Yaw = _task.Yaw.Radians;
                return (to.North, to.East, _task.HeightAboveHomeMetres, _task.SpeedMetresPerSecond);
            case VehicleCommandKind.Return:
                bool isHome = Math.Abs(North) < 1 && Math.Abs(East) < 1;
                return (0, 0, isHome ? 0 : Height, 8);
            case VehicleCommandKind.Land:
                return (North, East, 0, 0);
            default:
                return (North, East, Height, 0);
        }
    }
}
