namespace Rabit.Uav.Simulation;

/// <summary>Finds out by how long the ground is touched whether the vehicle has landed.</summary>
internal sealed class LandingDetector
{
    // Seconds of contact with the ground, until it counts as landed, and until the vehicle disarms by itself:
    // ap-takeover and the other recordings in tests/data/autopilots that end with LAND.
    private const double LandedAfter = 1.4;
    private const double DisarmsAfter = 2;

    private double _contactSeconds;

    /// <summary>Whether a landing that disarms is over.</summary>
    public bool IsDone => _contactSeconds >= DisarmsAfter;

    public void Reset() => _contactSeconds = 0;

    /// <summary>One step of an armed vehicle: says in the situation whether it has landed.</summary>
    public void Step(FlightSituation situation, in MotionCommand command)
    {
        if (command.Motors == MotorState.Flying && command.Velocity.Down < 0)
        {
            situation.IsLanded = false;
            _contactSeconds = 0;
            return;
        }

        _contactSeconds = situation.TouchesGround ? _contactSeconds + situation.StepSeconds : 0;
        situation.IsLanded |= _contactSeconds >= LandedAfter;
    }
}
