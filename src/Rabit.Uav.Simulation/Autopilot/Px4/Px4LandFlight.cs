using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// AUTO.LAND, and the last part of AUTO.RTL: straight down, at MPC_LAND_SPEED below 5 m. Without a position it goes
/// down all the same and drifts (DESCEND, which the heartbeat reports as AUTO.LAND too).
/// </summary>
internal sealed class Px4LandFlight : Px4Flight
{
    private const double FastAbove = 10;   // MPC_LAND_ALT1, metres
    private const double SlowBelow = 5;    // MPC_LAND_ALT2, metres
    private const double PartOfSpeed = 0.77;   // recorded: 1.0 to 1.5 m/s with MPC_LAND_SPEED 1.5

    private NedVector _place;

    public override bool IsLanding => true;

    public override NedVector? Target => _place;

    public override void Enter(Px4Situation situation) => _place = situation.StoppingPoint;

    /// <summary>Lands at a place instead of where it is.</summary>
    public void EnterAt(NedVector place) => _place = place;

    public override void Fly(Px4Situation situation, ref MotionCommand command)
    {
        if (situation.IsLanded)
        {
            command.Motors = MotorState.Idle;
            return;
        }

        Px4Parameters parameters = situation.Parameters;
        NedVector level = situation.HasPosition
            ? VelocityTo(situation, _place, situation.CruiseSpeed)
            : default;
        double part = NedMath.Limited((situation.Height - SlowBelow) / (FastAbove - SlowBelow), 0, 1);
        double down = parameters.LandSpeed.Value
            + (part * (parameters.AutoSpeedDown.Value - parameters.LandSpeed.Value));
        command.Velocity = new NedVector(level.North, level.East, PartOfSpeed * down);
    }
}
