using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// AUTO.MISSION: flies take-off, way-points, loiter, return and land items one after the other, and takes its speed
/// from DO_CHANGE_SPEED; the other DO items are passed over. From the ground it takes off first, whatever the first
/// item is. At the end it stays. Written after PX4 1.14's sources; no mission was recorded.
/// </summary>
internal sealed class Px4MissionFlight : Px4Flight
{
    private const double Reached = 2;   // NAV_ACC_RAD

    private readonly Px4LandFlight _landing = new();
    private readonly Px4TakeoffFlight _takeoff = new();
    private Part _part;
    private int _item;
    private NedVector _place;
    private TimeSpan? _leavesAt;
    private double _holdSeconds;
    private bool _takesOff;
    private bool _isOver;

    private enum Part
    {
        Stay,
        Fly,
        FlyToLand,
        Land,
    }

    /// <summary>What is flown.</summary>
    public Px4MissionService? Items { get; set; }

    /// <summary>Reads the place of an item; false where it has none.</summary>
    public AutoFlight.TryReadPlaceOf? Places { get; set; }

    public bool HasMission => Items is { Count: > 0 };

    /// <summary>Whether an item wants AUTO.RTL, until it is entered.</summary>
    public bool WantsReturn { get; private set; }

    public override bool IsTakingOff => _takesOff;

    public override bool IsLanding => _part == Part.Land;

    public override NedVector? Target => _place;

    /// <summary>On from the item where it was; from the first one where the mission was flown to its end.</summary>
    public override void Enter(Px4Situation situation)
    {
        if (_isOver)
            _item = 0;
        Begin(situation, _item);
    }

    /// <summary>Makes an item the current one.</summary>
    public void JumpTo(Px4Situation situation, int sequence, bool isFlying = false)
    {
        _item = sequence;
        _isOver = false;
        if (isFlying)
            Begin(situation, sequence);
    }

    public override void Fly(Px4Situation situation, ref MotionCommand command)
    {
        if (_takesOff)
        {
            _takeoff.Fly(situation, ref command);
            _takesOff = !_takeoff.IsDone;
            return;
        }

        if (situation.IsLanded)
        {
            if (_part == Part.Land && !_isOver)
                Finish();
            command.Motors = MotorState.Idle;
            return;
        }

        if (_part == Part.Land)
        {
            _landing.Fly(situation, ref command);
            return;
        }

        Advance(situation);
        command.Velocity = VelocityTo(situation, _place, situation.CruiseSpeed);
        PointAlong(situation, _place, ref command);
    }

    private void Advance(Px4Situation situation)
    {
        if (_part == Part.Stay || situation.Position.Minus(_place).Length > Reached)
            return;
        if (_part == Part.FlyToLand)
        {
            _part = Part.Land;
            _landing.EnterAt(_place);
            return;
        }

        _leavesAt ??= situation.Time + TimeSpan.FromTicks((long)(_holdSeconds * TimeSpan.TicksPerSecond));
        if (situation.Time < _leavesAt)
            return;
        Items!.ReportReached(_item);
        Begin(situation, _item + 1);
    }

    private void Begin(Px4Situation situation, int sequence)
    {
        (WantsReturn, _isOver, _takesOff, _leavesAt) = (false, false, false, null);
        for (int next = sequence; next < Items!.Count; next++)
        {
            if (!TryBegin(situation, Items[next]))
                continue;
            _item = next;
            Items.TrySetCurrent(next);
            Items.Report(MissionState.Active);
            if (WantsReturn)
                Finish();
            else if (situation.IsLanded)
                TakeOff(situation);
            return;
        }

        _place = situation.StoppingPoint;
        Stop();
    }

    // Straight up to the height of the item first, and at least to that of AUTO.TAKEOFF.
    private void TakeOff(Px4Situation situation)
    {
        NedVector here = situation.Position;
        double down = Math.Min(_place.Down, here.Down - situation.Parameters.TakeoffHeight.Value);
        if (_part == Part.FlyToLand)
            _place = new NedVector(_place.North, _place.East, down);
        _takeoff.Commanded = new NedVector(here.North, here.East, down);
        _takeoff.Enter(situation);
        _takesOff = true;
    }

    private void Finish()
    {
        Items!.ReportReached(_item);
        Stop();
    }

    private void Stop()
    {
        _part = Part.Stay;
        _isOver = true;
        Items!.Report(MissionState.Complete);
    }

    // Whether the item is one that takes time.
    private bool TryBegin(Px4Situation situation, in MissionItemInt item)
    {
        _holdSeconds = 0;
        switch (item.Command)
        {
            case MavCmd.NavTakeoff or MavCmd.NavWaypoint:
                (_part, _place) = (Part.Fly, PlaceOf(situation, item));
                _holdSeconds = item.Command == MavCmd.NavWaypoint ? item.Param1 : 0;
                return true;
            case MavCmd.NavLoiterTime:
                (_part, _place, _holdSeconds) = (Part.Fly, PlaceOf(situation, item), item.Param1);
                return true;
            case MavCmd.NavLoiterUnlim:
                (_part, _place) = (Part.Stay, PlaceOf(situation, item));
                return true;
            case MavCmd.NavLand:
                NedVector place = PlaceOf(situation, item);
                (_part, _place) =
                    (Part.FlyToLand, new NedVector(place.North, place.East, situation.Position.Down));
                return true;
            case MavCmd.NavReturnToLaunch:
                (_part, WantsReturn, _place) = (Part.Stay, true, situation.StoppingPoint);
                return true;
            case MavCmd.DoChangeSpeed when item.Param2 > 0:
                situation.CommandedSpeed = item.Param2;
                return false;
            default:
                return false;
        }
    }

    // An item without a place is where it is, at its height.
    private NedVector PlaceOf(Px4Situation situation, in MissionItemInt item)
    {
        if (Places is null || !Places(item.Frame, item.X, item.Y, item.Z, out NedVector place))
            return situation.StoppingPoint;
        return item.X == 0 && item.Y == 0
            ? new NedVector(situation.Position.North, situation.Position.East, place.Down)
            : place;
    }
}
