using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// AUTO: flies take-off, way-points, loiter, return and land items of the mission one after the other, and takes its
/// speed from DO_CHANGE_SPEED; the other DO items are passed over. On the ground it waits for MISSION_START.
/// </summary>
internal sealed class AutoFlight : FlightMode
{
    private const double Reached = 2;   // WPNAV_RADIUS
    private const double PointsAlongAbove = 0.05;
    private static readonly TimeSpan SpoolUp = TimeSpan.FromSeconds(3);

    private readonly GuidedHeading _heading = new();
    private readonly LandFlight _landing = new();
    private readonly ReturnFlight _return = new();
    private Part _part;
    private int _item = 1;
    private NedVector _place;
    private TimeSpan _liftsAt;
    private TimeSpan? _leavesAt;
    private double _holdSeconds;
    private double _speed;
    private bool _isStarted;
    private bool _isOver;

    private enum Part
    {
        Stay,
        TakeOff,
        Fly,
        Return,
        FlyToLand,
        Land,
    }

    public MissionService? Mission { get; set; }

    /// <summary>Reads the place of an item; false where it has none.</summary>
    public TryReadPlaceOf? Places { get; set; }

    public Action<MavSeverity, string>? Say { get; set; }

    public delegate bool TryReadPlaceOf(
        MavFrame axes, int latitudeDegE7, int longitudeDegE7, float altitude, out NedVector place);

    /// <summary>Whether there is anything but home.</summary>
    public bool HasMission => Mission is { Count: > 1 };

    public override bool IsTakingOff => _part == Part.TakeOff;

    public override bool IsLanding => _part == Part.Land || (_part == Part.Return && _return.IsLanding);

    public override bool DisarmsWhenLanded => _part is Part.Land or Part.Return;

    /// <summary>From the first item on, the next time.</summary>
    public void Rewind() => _item = 1;

    public override void Enter(FlightSituation situation)
    {
        _speed = situation.Parameters.Speed.Value / 100;
        _part = Part.Stay;
        _place = situation.StoppingPoint;
        _heading.Follow(situation.Yaw);
        _isStarted = false;
        if (!situation.IsLanded)
            Start(situation);
    }

    /// <summary>MISSION_START, and the entry in flight: on from the item where it was.</summary>
    public void Start(FlightSituation situation)
    {
        if (_isStarted)
            return;
        _isStarted = true;
        Begin(situation, _item);
    }

    /// <summary>DO_SET_MISSION_CURRENT.</summary>
    public void JumpTo(FlightSituation situation, int sequence, bool isFlying)
    {
        _item = Math.Max(1, sequence);
        if (isFlying && _isStarted)
            Begin(situation, _item);
    }

    public override void Fly(FlightSituation situation, ref MotionCommand command)
    {
        if (situation.IsLanded && (_part != Part.TakeOff || situation.Time < _liftsAt))
        {
            if (DisarmsWhenLanded && !_isOver)
                Finish();
            command.Motors = MotorState.Idle;
            return;
        }

        if (_part == Part.Return)
        {
            _return.Fly(situation, ref command);
            return;
        }

        if (_part == Part.Land)
        {
            _landing.Fly(situation, ref command);
            return;
        }

        Advance(situation);
        ParameterStore parameters = situation.Parameters;
        command.Velocity = VelocityTo(
            situation, _place, _speed, parameters.SpeedUp.Value / 100, parameters.SpeedDown.Value / 100);
        bool pointsAlong = parameters.YawBehaviour.Value > 0
            && command.Velocity.HorizontalLength() > PointsAlongAbove * _speed;
        _heading.Fly(situation, pointsAlong ? command.Velocity : default, ref command);
    }

    // On the ground again: from the front the next time.
    private void Finish()
    {
        _isOver = true;
        ReportReached();
        _item = 1;
        Mission!.Report(MissionState.Complete);
    }

    private void ReportReached()
    {
        Mission!.ReportReached(_item);
        Say?.Invoke(MavSeverity.Info, FormattableString.Invariant($"Reached command #{_item}"));
    }

    private void Advance(FlightSituation situation)
    {
        if (_part == Part.Stay || situation.Position.Minus(_place).Length > Reached)
            return;
        if (_part == Part.FlyToLand)
        {
            _part = Part.Land;
            _landing.EnterAt(_place);
            return;
        }

        _leavesAt ??= situation.Time + TimeSpan.OfSeconds(_holdSeconds);
        if (situation.Time < _leavesAt)
            return;
        ReportReached();
        Begin(situation, _item + 1);
    }

    private void Begin(FlightSituation situation, int sequence)
    {
        for (int next = sequence; next < Mission!.Count; next++)
        {
            MissionItemInt item = Mission[next];
            if (!TryBegin(situation, item, out string name))
                continue;
            _item = next;
            _leavesAt = null;
            _isOver = false;
            Mission.Report(MissionState.Active);
            Mission.TrySetCurrent(next);
            Say?.Invoke(MavSeverity.Info, FormattableString.Invariant($"Mission: {next} {name}"));
            return;
        }

        // The end: it stays where it is, and begins from the front the next time.
        _part = Part.Stay;
        _place = situation.StoppingPoint;
        _item = 1;
        Mission.Report(MissionState.Complete);
    }

    // Whether the item is one that takes time.
    private bool TryBegin(FlightSituation situation, in MissionItemInt item, out string name)
    {
        name = "";
        switch (item.Command)
        {
            case MavCmd.NavTakeoff:
                (_part, name, _holdSeconds) = (Part.TakeOff, "Takeoff", 0);
                _place = new NedVector(
                    situation.Position.North, situation.Position.East, situation.Home.Down - item.Z);
                _liftsAt = situation.Time + (situation.IsLanded ? SpoolUp : TimeSpan.Zero);
                return true;
            case MavCmd.NavWaypoint:
                (_part, name, _holdSeconds) = (Part.Fly, "WP", item.Param1);
                _place = PlaceOf(situation, item);
                return true;
            case MavCmd.NavLoiterTime:
                (_part, name, _holdSeconds) = (Part.Fly, "LoitTime", item.Param1);
                _place = PlaceOf(situation, item);
                return true;
            case MavCmd.NavLoiterUnlim:
                (_part, name) = (Part.Stay, "LoitUnlim");
                _place = PlaceOf(situation, item);
                return true;
            case MavCmd.NavReturnToLaunch:
                (_part, name) = (Part.Return, "RTL");
                _return.Enter(situation);
                return true;
            case MavCmd.NavLand:
                (_part, name) = (Part.FlyToLand, "Land");
                _landing.Enter(situation);
                NedVector place = PlaceOf(situation, item);
                _place = new NedVector(place.North, place.East, situation.Position.Down);
                return true;
            case MavCmd.DoChangeSpeed when item.Param2 > 0:
                _speed = item.Param2;
                return false;
            default:
                return false;
        }
    }

    private NedVector PlaceOf(FlightSituation situation, in MissionItemInt item)
        => Places is not null && Places(item.Frame, item.X, item.Y, item.Z, out NedVector place)
            ? place
            : situation.StoppingPoint;
}
