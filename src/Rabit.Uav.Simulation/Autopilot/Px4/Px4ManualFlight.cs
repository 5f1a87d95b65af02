using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// POSCTL and ALTCTL, flown by the sticks. POSCTL holds its place where there are none; ALTCTL then sinks, as a
/// throttle stick at its lower end says (recorded after the loss of the GPS). Sideways ALTCTL comes to rest against the
/// air: how sticks tilt it is not simulated.
/// </summary>
internal sealed class Px4ManualFlight(bool holdsPosition) : Px4Flight
{
    private const double BrakeAcceleration = 3.5;   // m/s2; recorded: 4.6 m from 6 m/s to the stop
    private const double MaxYawRate = 150 * NedMath.RadiansPerDegree;   // MPC_MAN_Y_MAX
    private const double Standing = 0.1;            // m/s, below which the place is held
    private const double DriftAcceleration = 0.5;   // m/s2 without a position
    private const double LiftsAbove = 0.3;

    private NedVector? _place;
    private NedVector _level;

    public override void Enter(Px4Situation situation)
    {
        _place = null;
        _level = situation.Position;
    }

    public override void Fly(Px4Situation situation, ref MotionCommand command)
    {
        Px4Sticks sticks = situation.Sticks;
        double down = Down(situation);
        if (situation.IsLanded && down > -LiftsAbove)
        {
            command.Motors = MotorState.Idle;
            return;
        }

        situation.IsLanded = false;
        NedVector level = holdsPosition ? Level(situation, ref command) : default;
        if (!holdsPosition)
            command.HorizontalAcceleration = DriftAcceleration;
        command.Velocity = new NedVector(level.North, level.East, down);
        command.YawRate = sticks.AreValid ? MaxYawRate * Px4Sticks.Curve(sticks.Yaw) : 0;
    }

    private NedVector Level(Px4Situation situation, ref MotionCommand command)
    {
        Px4Sticks sticks = situation.Sticks;
        double ahead = sticks.AreValid ? Px4Sticks.Curve(sticks.Pitch) : 0;
        double right = sticks.AreValid ? Px4Sticks.Curve(sticks.Roll) : 0;
        double stick = Math.Sqrt((ahead * ahead) + (right * right));
        if (stick > 0)
        {
            // MPC_POS_MODE 4: the stick says how fast to gain speed.
            _place = null;
            command.HorizontalAcceleration = stick * situation.Parameters.Acceleration.Value;
            double speed = situation.Parameters.ManualSpeed.Value;
            (double sin, double cos) = (Trig.Sin(situation.Yaw), Trig.Cos(situation.Yaw));
            return new NedVector((ahead * cos) - (right * sin), (ahead * sin) + (right * cos), 0).Times(speed);
        }

        command.HorizontalAcceleration = BrakeAcceleration;
        if (_place is null && situation.Velocity.HorizontalLength() < Standing)
            _place = situation.Position;
        return _place is { } place ? place.Minus(situation.Position) : default;
    }

    private double Down(Px4Situation situation)
    {
        Px4Parameters parameters = situation.Parameters;
        Px4Sticks sticks = situation.Sticks;
        double throttle = sticks.AreValid ? Px4Sticks.Curve(sticks.Throttle) : holdsPosition ? 0 : -1;
        if (Math.Abs(throttle) < 1e-6)
            return Vertical(situation, _level.Down - situation.Position.Down, parameters.MaxSpeedDown.Value);
        _level = situation.Position;
        return throttle > 0 ? -throttle * parameters.MaxSpeedUp.Value : -throttle * parameters.MaxSpeedDown.Value;
    }
}
