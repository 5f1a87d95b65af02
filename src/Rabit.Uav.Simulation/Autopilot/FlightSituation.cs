using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What a flight mode flies by: the autopilot's own estimate, not the truth. Metres in the frame of the world, as far
/// as the autopilot knows it. Set by <see cref="FlightController"/> before each step.
/// </summary>
internal sealed class FlightSituation(ParameterStore parameters)
{
    public ParameterStore Parameters { get; } = parameters;

    /// <summary>By the clock of the run.</summary>
    public TimeSpan Time { get; set; }

    public double StepSeconds { get; set; }

    public NedVector Position { get; set; }

    public NedVector Velocity { get; set; }

    public double Yaw { get; set; }

    public NedVector Home { get; set; }

    /// <summary>Whether it counts on <see cref="Position"/>; without it, it only keeps level.</summary>
    public bool HasPosition { get; set; }

    /// <summary>What the weight on the legs says.</summary>
    public bool TouchesGround { get; set; }

    /// <summary>By the autopilot's estimate: it is on the ground and waits for a take-off.</summary>
    public bool IsLanded { get; set; } = true;

    /// <summary>Metres above home, up positive.</summary>
    public double Height => Home.Down - Position.Down;

    public double HorizontalAcceleration => Parameters.Acceleration.Value / 100;

    public double VerticalAcceleration => Parameters.VerticalAcceleration.Value / 100;

    /// <summary>Takes over what was known before a reset in flight.</summary>
    public void CopyFrom(FlightSituation other)
    {
        (Time, StepSeconds, Position, Velocity) = (other.Time, other.StepSeconds, other.Position, other.Velocity);
        (Yaw, Home, TouchesGround, IsLanded) = (other.Yaw, other.Home, other.TouchesGround, other.IsLanded);
    }

    /// <summary>Where it comes to rest if it brakes now.</summary>
    public NedVector StoppingPoint
    {
        get
        {
            double speed = Velocity.HorizontalLength();
            NedVector ahead = Velocity.Times(speed / (2 * HorizontalAcceleration));
            double rise = Velocity.Down * Math.Abs(Velocity.Down) / (2 * VerticalAcceleration);
            return Position.Plus(new NedVector(ahead.North, ahead.East, rise));
        }
    }
}
