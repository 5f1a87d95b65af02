using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>One way to fly. Entered, then asked for a command at each step until another mode is entered.</summary>
internal abstract class Px4Flight
{
    // Braking is planned slower than MPC_ACC_HOR allows, for the limit of the jerk (recorded: 4.7 m/s at 10 m from the
    // place, 2.2 m/s at 2 m); so is climbing before the height is reached.
    private const double PlannedDeceleration = 1.2;
    private const double PlannedVerticalDeceleration = 0.6;

    /// <summary>Whether EXTENDED_SYS_STATE says that it takes off.</summary>
    public virtual bool IsTakingOff => false;

    /// <summary>Whether EXTENDED_SYS_STATE says that it lands.</summary>
    public virtual bool IsLanding => false;

    /// <summary>Where it flies to by itself, for POSITION_TARGET_GLOBAL_INT; null where it does not.</summary>
    public virtual NedVector? Target => null;

    public abstract void Enter(Px4Situation situation);

    /// <summary>
    /// The command for the next step. It comes with the motors flying, the accelerations of the AUTO modes, and no
    /// heading, which keeps it.
    /// </summary>
    public abstract void Fly(Px4Situation situation, ref MotionCommand command);

    /// <summary>The velocity that leads to a place and stops there, as an AUTO mode plans it.</summary>
    protected static NedVector VelocityTo(Px4Situation situation, NedVector place, double speed)
    {
        Px4Parameters parameters = situation.Parameters;
        NedVector error = place.Minus(situation.Position);
        double distance = error.HorizontalLength();
        double horizontal = Approach(distance, speed, PlannedDeceleration, parameters.PositionGain.Value);
        double part = distance > 1e-6 ? horizontal / distance : 0;
        double limit = error.Down < 0 ? parameters.AutoSpeedUp.Value : parameters.AutoSpeedDown.Value;
        return new NedVector(error.North * part, error.East * part, Vertical(situation, error.Down, limit));
    }

    /// <summary>The vertical velocity that leads to a height and stops there, down positive.</summary>
    protected static double Vertical(Px4Situation situation, double errorDown, double speed)
        => Math.Sign(errorDown) * Approach(
            Math.Abs(errorDown), speed, PlannedVerticalDeceleration, situation.Parameters.HeightGain.Value);

    /// <summary>Turns the nose along the flight, unless the place is near.</summary>
    protected static void PointAlong(Px4Situation situation, NedVector place, ref MotionCommand command)
    {
        const double Near = 2;   // NAV_ACC_RAD
        NedVector error = place.Minus(situation.Position);
        if (error.HorizontalLength() > Near)
            command.Yaw = Math.Atan2(error.East, error.North);
    }

    private static double Approach(double distance, double speed, double deceleration, double gain)
    {
        double near = deceleration / (gain * gain);
        double possible = distance <= near
            ? gain * distance
            : Math.Sqrt(2 * deceleration * (distance - (near / 2)));
        return Math.Min(speed, possible);
    }
}
