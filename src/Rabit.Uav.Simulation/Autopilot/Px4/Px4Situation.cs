using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What PX4 flies by: its own estimate, not the truth. Metres in the frame of the world, as far as it knows it. Set by
/// <see cref="Px4Controller"/> before each step.
/// </summary>
internal sealed class Px4Situation(Px4Parameters parameters, Px4Sticks sticks, double stepSeconds)
{
    public Px4Parameters Parameters { get; } = parameters;

    public Px4Sticks Sticks { get; } = sticks;

    public double StepSeconds { get; } = stepSeconds;

    /// <summary>By the clock of the run.</summary>
    public TimeSpan Time { get; set; }

    public NedVector Position { get; set; }

    public NedVector Velocity { get; set; }

    public double Yaw { get; set; }

    /// <summary>Null until it has known its position.</summary>
    public NedVector? Home { get; set; }

    /// <summary>Whether the position is valid now.</summary>
    public bool HasPosition { get; set; }

    /// <summary>What the weight on the legs says.</summary>
    public bool TouchesGround { get; set; }

    /// <summary>By the autopilot's own detection.</summary>
    public bool IsLanded { get; set; } = true;

    public TimeSpan ArmedAt { get; set; }

    /// <summary>By DO_CHANGE_SPEED, m/s; null: MPC_XY_CRUISE. Back to null with each change of the mode.</summary>
    public double? CommandedSpeed { get; set; }

    public double CruiseSpeed => Math.Min(CommandedSpeed ?? Parameters.CruiseSpeed.Value, Parameters.MaxSpeed.Value);

    /// <summary>Above home, metres, up positive.</summary>
    public double Height => (Home ?? default).Down - Position.Down;

    /// <summary>Where it comes to rest if it brakes now as PX4 plans it.</summary>
    public NedVector StoppingPoint
    {
        get
        {
            // Recorded: 7 to 8 m from 6 m/s in AUTO.LOITER, with MPC_ACC_HOR 3 and the limit of the jerk.
            const double PartOfAcceleration = 0.8;
            double speed = Velocity.HorizontalLength();
            NedVector ahead = Velocity.Times(speed / (2 * PartOfAcceleration * Parameters.Acceleration.Value));
            return Position.Plus(new NedVector(ahead.North, ahead.East, 0.5 * Velocity.Down));
        }
    }
}
