using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// GUIDED: take-off, position targets, which persist, and velocity targets, which time out. On the ground it waits
/// for a take-off and flies to no target.
/// </summary>
internal sealed class GuidedFlight : FlightMode
{
    private const double TakeOffReached = 0.1;
    private static readonly TimeSpan SpoolUp = TimeSpan.FromSeconds(3);

    // ArduCopter turns along the flight above 5 % of the speed limit.
    private const double PointsAlongAbove = 0.05;

    private readonly GuidedHeading _heading = new();
    private Task _task;
    private NedVector _place;
    private NedVector _velocity;
    private NedVector? _pausedAt;
    private TimeSpan _targetTime;
    private TimeSpan _liftsAt;
    private bool _isUp;
    private bool _hasTarget;
    private double _speed;
    private double _speedUp;
    private double _speedDown;

    private enum Task
    {
        Place,
        Velocity,
        PlaceAndVelocity,
        TakeOff,
    }

    public override bool IsTakingOff => _task == Task.TakeOff && !_isUp;

    public override void Enter(FlightSituation situation)
    {
        ResetSpeeds(situation);
        Stop(situation);
    }

    /// <summary>
    /// What POSITION_TARGET_LOCAL_NED reports: a place, a velocity, or both; from its entry on, and after an invalid
    /// target, velocity zero.
    /// </summary>
    public (NedVector? Place, NedVector? Velocity) Target => _task switch
    {
        Task.Velocity => (null, _velocity),
        Task.PlaceAndVelocity => (_place, _velocity),
        _ when _hasTarget => (_place, null),
        _ => (null, default(NedVector)),
    };

    /// <summary>Brakes and stays; also what an invalid target leads to.</summary>
    public void Stop(FlightSituation situation)
    {
        Take(Task.Place, situation);
        _place = situation.StoppingPoint;
        _hasTarget = false;
        _heading.Follow(situation.Yaw);
    }

    public void TakeOff(FlightSituation situation, double heightMetres)
    {
        Take(Task.TakeOff, situation);
        _isUp = false;
        _place = new NedVector(situation.Position.North, situation.Position.East, situation.Home.Down - heightMetres);
        _liftsAt = situation.Time + SpoolUp;
        _heading.Turn(situation.Yaw);
    }

    public void GoTo(FlightSituation situation, NedVector place, in HeadingTarget heading)
    {
        Take(Task.Place, situation);
        _place = place;
        _heading.Set(heading);
    }

    public void FlyVelocity(FlightSituation situation, NedVector velocity, in HeadingTarget heading)
    {
        Take(Task.Velocity, situation);
        _velocity = velocity;
        _heading.Set(heading);
    }

    public void GoToWithVelocity(
        FlightSituation situation, NedVector place, NedVector velocity, in HeadingTarget heading)
    {
        Take(Task.PlaceAndVelocity, situation);
        _place = place;
        _velocity = velocity;
        _heading.Set(heading);
    }

    /// <summary>CONDITION_YAW.</summary>
    public void Turn(double yawRadians) => _heading.Turn(yawRadians);

    /// <summary>Stands still in the air, and keeps what it was flying to.</summary>
    public void Pause(FlightSituation situation)
    {
        _pausedAt ??= situation.StoppingPoint;
    }

    public void GoOn(FlightSituation situation)
    {
        _pausedAt = null;
        _targetTime = situation.Time;
    }

    /// <summary>m/s.</summary>
    public void SetSpeed(double speed) => _speed = speed;

    /// <summary>m/s.</summary>
    public void SetSpeedUp(double speed) => _speedUp = speed;

    /// <summary>m/s.</summary>
    public void SetSpeedDown(double speed) => _speedDown = speed;

    public override void Fly(FlightSituation situation, ref MotionCommand command)
    {
        if (situation.IsLanded && (_task != Task.TakeOff || situation.Time < _liftsAt))
        {
            command.Motors = MotorState.Idle;
            return;
        }

        if (_pausedAt is { } stop)
        {
            command.Velocity = VelocityTo(situation, stop, _speed, _speedUp, _speedDown);
            return;
        }

        EndTasks(situation);
        command.Velocity = Velocity(situation);
        bool pointsAlong = situation.Parameters.YawBehaviour.Value > 0
            && command.Velocity.HorizontalLength() > PointsAlongAbove * _speed;
        _heading.Fly(situation, pointsAlong ? command.Velocity : default, ref command);
    }

    private void Take(Task task, FlightSituation situation)
    {
        // A new kind of task turns along its flight again and flies with the speeds of the parameters, whatever
        // DO_CHANGE_SPEED said before; a new target of the same kind leaves both as commanded, as the recorded
        // ArduCopter does.
        if (task != _task)
        {
            _heading.Follow(situation.Yaw);
            ResetSpeeds(situation);
        }

        _task = task;
        _hasTarget = true;
        _pausedAt = null;
        _targetTime = situation.Time;
    }

    private void ResetSpeeds(FlightSituation situation)
    {
        _speed = situation.Parameters.Speed.Value / 100;
        _speedUp = situation.Parameters.SpeedUp.Value / 100;
        _speedDown = situation.Parameters.SpeedDown.Value / 100;
    }

    private void EndTasks(FlightSituation situation)
    {
        _isUp |= _task == Task.TakeOff && Math.Abs(_place.Down - situation.Position.Down) < TakeOffReached;
        if (_task is not (Task.Velocity or Task.PlaceAndVelocity)
            || (situation.Time - _targetTime).ExactSeconds <= situation.Parameters.GuidedTimeout.Value)
        {
            return;
        }

        if (_task == Task.Velocity)
            _place = situation.StoppingPoint;
        Take(Task.Place, situation);
        _heading.Turn(situation.Yaw);
    }

    private NedVector Velocity(FlightSituation situation)
    {
        if (_task == Task.Velocity)
            return Limited(_velocity);
        NedVector towards = VelocityTo(situation, _place, _speed, _speedUp, _speedDown);
        if (_task != Task.PlaceAndVelocity)
            return towards;

        // The place moves on with its velocity.
        _place = _place.Plus(_velocity.Times(situation.StepSeconds));
        return Limited(towards.Plus(_velocity));
    }

    private NedVector Limited(NedVector velocity)
    {
        NedVector level = velocity.LimitedHorizontally(_speed);
        return new NedVector(level.North, level.East, NedMath.Limited(level.Down, -_speedUp, _speedDown));
    }
}
