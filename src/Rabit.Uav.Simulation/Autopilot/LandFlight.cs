using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>LAND, and the last part of RTL: straight down, slower near the ground, until it stands.</summary>
internal sealed class LandFlight : FlightMode
{
    private NedVector _place;

    public override bool IsLanding => true;

    public override bool DisarmsWhenLanded => true;

    public override void Enter(FlightSituation situation) => _place = situation.StoppingPoint;

    /// <summary>Lands at a place instead of where it is.</summary>
    public void EnterAt(NedVector place) => _place = place;

    public override void Fly(FlightSituation situation, ref MotionCommand command)
    {
        if (situation.IsLanded)
        {
            command.Motors = MotorState.Idle;
            return;
        }

        ParameterStore parameters = situation.Parameters;
        NedVector velocity = VelocityTo(situation, _place);
        double high = parameters.LandSpeedHigh.Value > 0 ? parameters.LandSpeedHigh.Value : parameters.SpeedDown.Value;
        double down = situation.Height > parameters.LandLowHeight.Value / 100 ? high : parameters.LandSpeed.Value;
        command.Velocity = new NedVector(velocity.North, velocity.East, down / 100);
    }
}
