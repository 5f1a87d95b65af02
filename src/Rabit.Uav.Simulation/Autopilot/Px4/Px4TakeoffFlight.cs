using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>AUTO.TAKEOFF: straight up to a height above sea level; then the controller takes AUTO.LOITER.</summary>
internal sealed class Px4TakeoffFlight : Px4Flight
{
    private const double Reached = 0.8;             // NAV_MC_ALT_RAD, metres
    private const double RampAcceleration = 1.3;    // m/s2: MPC_TKO_RAMP_T

    // Recorded from arming: "takeoff detected" after 1.9 s (COM_SPOOLUP_TIME and the ramp), in the air after 2.9 s.
    private static readonly TimeSpan Detected = TimeSpan.OfSeconds(1.9);
    private static readonly TimeSpan Lifts = TimeSpan.OfSeconds(2.9);

    private NedVector _place;
    private TimeSpan _start;

    public override bool IsTakingOff => true;

    public override NedVector? Target => _place;

    /// <summary>Whether it is at the commanded height.</summary>
    public bool IsDone { get; private set; }

    /// <summary>Where to: set before the mode is entered.</summary>
    public NedVector? Commanded { get; set; }

    public override void Enter(Px4Situation situation)
    {
        double above = situation.Position.Down - situation.Parameters.TakeoffHeight.Value;
        NedVector here = situation.Position;
        _place = Commanded ?? new NedVector(here.North, here.East, above);
        if (_place.Down > here.Down)
            _place = new NedVector(_place.North, _place.East, here.Down);
        _start = situation.Time;
        IsDone = false;
    }

    public override void Fly(Px4Situation situation, ref MotionCommand command)
    {
        command.VerticalAcceleration = RampAcceleration;
        TimeSpan since = situation.Time - (situation.ArmedAt > _start ? situation.ArmedAt : _start);
        if (situation.IsLanded && since < Detected)
        {
            command.Motors = MotorState.Idle;
            return;
        }

        situation.IsLanded = false;
        if (situation.TouchesGround && since < Lifts)
        {
            command.Motors = MotorState.Idle;
            return;
        }

        double error = _place.Down - situation.Position.Down;
        double speed = Math.Min(situation.Parameters.TakeoffSpeed.Value, situation.Parameters.MaxSpeedUp.Value);
        NedVector level = VelocityTo(situation, _place, situation.CruiseSpeed);
        command.Velocity = new NedVector(level.North, level.East, Vertical(situation, error, speed));
        IsDone = Math.Abs(error) < Reached;
    }
}
