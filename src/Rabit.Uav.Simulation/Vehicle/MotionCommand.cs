using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>What a flight mode wants of the vehicle for the next step. A plain value.</summary>
internal struct MotionCommand
{
    public MotorState Motors;

    /// <summary>Over ground, m/s.</summary>
    public NedVector Velocity;

    /// <summary>It only keeps level, and drifts with the air; the horizontal velocity is not flown.</summary>
    public bool KeepsLevel;

    /// <summary>How fast the velocity may change horizontally, m/s2.</summary>
    public double HorizontalAcceleration;

    /// <summary>How fast it may change vertically, m/s2.</summary>
    public double VerticalAcceleration;

    /// <summary>Heading to turn to, radians clockwise from north; NaN: turn at <see cref="YawRate"/>.</summary>
    public double Yaw;

    /// <summary>Radians per second, where no heading is given.</summary>
    public double YawRate;
}
