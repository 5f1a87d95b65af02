using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>DO_ORBIT: a circle, clockwise where the radius is positive, with the nose to the middle.</summary>
internal sealed class Px4OrbitFlight : Px4Flight
{
    private const double InwardGain = 0.5;   // 1/s

    private NedVector _middle;
    private double _radius;
    private double _speed;

    /// <summary>Set before the mode is entered.</summary>
    public void Circle(NedVector middle, double radius, double speed)
        => (_middle, _radius, _speed) = (middle, radius, speed);

    public override void Enter(Px4Situation situation)
    {
    }

    public override void Fly(Px4Situation situation, ref MotionCommand command)
    {
        if (situation.IsLanded)
        {
            command.Motors = MotorState.Idle;
            return;
        }

        NedVector outward = situation.Position.Minus(_middle);
        double distance = Math.Max(0.1, outward.HorizontalLength());
        (double north, double east) = (outward.North / distance, outward.East / distance);
        double radius = Math.Abs(_radius);
        double along = _radius < 0 ? -_speed : _speed;
        double inward = NedMath.Limited(InwardGain * (radius - distance), -_speed, _speed);
        double down = Vertical(
            situation, _middle.Down - situation.Position.Down, situation.Parameters.AutoSpeedUp.Value);
        command.Velocity = new NedVector((north * inward) - (east * along), (east * inward) + (north * along), down);
        command.HorizontalAcceleration = situation.Parameters.MaxAcceleration.Value;
        command.Yaw = Math.Atan2(-outward.East, -outward.North);
    }
}
