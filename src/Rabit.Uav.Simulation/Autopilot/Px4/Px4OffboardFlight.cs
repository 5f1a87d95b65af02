using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// OFFBOARD: a position controller with the velocity as feed-forward. It plans nothing: a place far away is a jump that
/// only the limits of speed and acceleration hold back; DO_CHANGE_SPEED has no effect.
/// </summary>
internal sealed class Px4OffboardFlight : Px4Flight
{
    private const double LiftsAbove = 0.3;   // m/s upwards: from the ground it takes off
    private const double VelocityGain = 1.8;          // 1/s: MPC_XY_VEL_P_ACC
    private const double MinAcceleration = 0.3;     // m/s2

    private Px4SetPoint _setPoint;

    public override NedVector? Target => double.IsNaN(_setPoint.Position.North) ? null : _setPoint.Position;

    /// <summary>The newest one, in any mode.</summary>
    public void Take(in Px4SetPoint setPoint) => _setPoint = setPoint;

    public override void Enter(Px4Situation situation)
    {
    }

    public override void Fly(Px4Situation situation, ref MotionCommand command)
    {
        Px4Parameters parameters = situation.Parameters;
        NedVector velocity = Velocity(situation).LimitedHorizontally(parameters.MaxSpeed.Value);
        double down = NedMath.Limited(velocity.Down, -parameters.MaxSpeedUp.Value, parameters.MaxSpeedDown.Value);
        if (situation.IsLanded && down > -LiftsAbove)
        {
            command.Motors = MotorState.Idle;
            return;
        }

        situation.IsLanded = false;
        command.Velocity = new NedVector(velocity.North, velocity.East, down);
        double change = command.Velocity.Minus(situation.Velocity).HorizontalLength();
        command.HorizontalAcceleration = NedMath.Limited(
            VelocityGain * change, MinAcceleration, parameters.MaxAcceleration.Value);
        command.Yaw = _setPoint.Yaw;
        command.YawRate = double.IsNaN(_setPoint.YawRate) ? 0 : _setPoint.YawRate;
    }

    private NedVector Velocity(Px4Situation situation)
    {
        double gain = situation.Parameters.PositionGain.Value;
        NedVector error = _setPoint.Position.Minus(situation.Position);
        return new NedVector(
            Sum(error.North * gain, _setPoint.Velocity.North),
            Sum(error.East * gain, _setPoint.Velocity.East),
            Sum(error.Down * situation.Parameters.HeightGain.Value, _setPoint.Velocity.Down));
    }

    private static double Sum(double fromPosition, double feedForward)
        => (double.IsNaN(fromPosition) ? 0 : fromPosition) + (double.IsNaN(feedForward) ? 0 : feedForward);
}
