using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>One way to fly. Entered, then asked for a command at each step until another mode is entered.</summary>
internal abstract class FlightMode
{
    // The gain of ArduCopter's position controller (PSC_POSXY_P, PSC_POSZ_P).
    private const double PositionGain = 1;

    // Braking is planned with less than the limit: the loop needs the rest.
    private const double PlannedPart = 0.7;

    /// <summary>Whether EXTENDED_SYS_STATE says that it takes off.</summary>
    public virtual bool IsTakingOff => false;

    /// <summary>Whether EXTENDED_SYS_STATE says that it lands.</summary>
    public virtual bool IsLanding => false;

    /// <summary>Whether it disarms by itself when it has landed.</summary>
    public virtual bool DisarmsWhenLanded => false;

    public abstract void Enter(FlightSituation situation);

    /// <summary>
    /// The command for the next step. It comes with the motors flying or, on the ground, idling; the heading is kept
    /// if nothing is said.
    /// </summary>
    public abstract void Fly(FlightSituation situation, ref MotionCommand command);

    /// <summary>The velocity that leads to a place and stops there.</summary>
    protected static NedVector VelocityTo(
        FlightSituation situation, NedVector place, double speed, double speedUp, double speedDown)
    {
        NedVector error = place.Minus(situation.Position);
        double distance = error.HorizontalLength();
        double horizontal = Approach(distance, speed, situation.HorizontalAcceleration * PlannedPart);
        double part = distance > 1e-6 ? horizontal / distance : 0;
        double vertical = Approach(
            Math.Abs(error.Down), error.Down < 0 ? speedUp : speedDown, situation.VerticalAcceleration * PlannedPart);
        return new NedVector(error.North * part, error.East * part, error.Down < 0 ? -vertical : vertical);
    }

    /// <summary>As above, with the speeds of the parameters.</summary>
    protected static NedVector VelocityTo(FlightSituation situation, NedVector place)
    {
        ParameterStore parameters = situation.Parameters;
        return VelocityTo(
            situation, place, parameters.Speed.Value / 100, parameters.SpeedUp.Value / 100,
            parameters.SpeedDown.Value / 100);
    }

    // Proportional near the place, as much as braking allows further away (ArduPilot's square root controller).
    private static double Approach(double distance, double speed, double deceleration)
    {
        double near = deceleration / (PositionGain * PositionGain);
        double possible = distance <= near
            ? PositionGain * distance
            : Math.Sqrt(2 * deceleration * (distance - (near / 2)));
        return Math.Min(speed, possible);
    }
}
