using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// LOITER and BRAKE, and the modes that a pilot flies manually: it stops and stays. A pilot of the simulation holds
/// the sticks so that it does.
/// </summary>
internal sealed class HoldFlight : FlightMode
{
    private NedVector _place;

    public override void Enter(FlightSituation situation) => _place = situation.StoppingPoint;

    public override void Fly(FlightSituation situation, ref MotionCommand command)
    {
        if (situation.IsLanded)
            command.Motors = MotorState.Idle;
        else
            command.Velocity = VelocityTo(situation, _place);
    }
}
