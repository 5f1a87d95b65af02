namespace Rabit.Uav.Geometry;

/// <summary>Angular velocity in the body frame (forward-right-down), radians per second. A plain value.</summary>
/// <param name="rollRadiansPerSecond">About forward.</param>
/// <param name="pitchRadiansPerSecond">About right.</param>
/// <param name="yawRadiansPerSecond">About down.</param>
public readonly struct BodyRates(double rollRadiansPerSecond, double pitchRadiansPerSecond, double yawRadiansPerSecond)
{
    /// <summary>About forward.</summary>
    public double RollRadiansPerSecond { get; } = rollRadiansPerSecond;

    /// <summary>About right.</summary>
    public double PitchRadiansPerSecond { get; } = pitchRadiansPerSecond;

    /// <summary>About down.</summary>
    public double YawRadiansPerSecond { get; } = yawRadiansPerSecond;
}
