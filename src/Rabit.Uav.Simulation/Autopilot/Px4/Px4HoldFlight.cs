using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// AUTO.LOITER: stops and stays, or flies where DO_REPOSITION sends it. Commanding it again changes nothing.
/// </summary>
internal sealed class Px4HoldFlight : Px4Flight
{
    private NedVector _place;
    private double _yaw;

    public override NedVector? Target => _place;

    public override void Enter(Px4Situation situation)
    {
        _place = situation.StoppingPoint;
        _yaw = double.NaN;
    }

    /// <summary>DO_REPOSITION.</summary>
    /// <param name="place">Where to.</param>
    /// <param name="yaw">Radians; NaN: along the flight.</param>
    public void GoTo(NedVector place, double yaw)
    {
        _place = place;
        _yaw = yaw;
    }

    public override void Fly(Px4Situation situation, ref MotionCommand command)
    {
        if (situation.IsLanded)
        {
            command.Motors = MotorState.Idle;
            return;
        }

        command.Velocity = VelocityTo(situation, _place, situation.CruiseSpeed);
        command.Yaw = _yaw;
        if (double.IsNaN(_yaw))
            PointAlong(situation, _place, ref command);
    }
}
