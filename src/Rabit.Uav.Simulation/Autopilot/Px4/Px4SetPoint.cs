using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>What a set-point of OFFBOARD says. A plain value; what is not said is NaN.</summary>
internal struct Px4SetPoint
{
    /// <summary>Metres in the world; north and east NaN together.</summary>
    public NedVector Position;

    /// <summary>m/s over ground.</summary>
    public NedVector Velocity;

    /// <summary>Radians.</summary>
    public double Yaw;

    /// <summary>Radians per second.</summary>
    public double YawRate;

    public readonly bool HasPosition => !double.IsNaN(Position.North) || !double.IsNaN(Position.Down);
}
