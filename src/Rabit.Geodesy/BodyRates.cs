namespace Rabit.Geodesy;

/// <summary>Angular velocity in the body frame (forward-right-down). A plain value, made from numbers by a method that names the unit.</summary>
public readonly struct BodyRates
{
    private BodyRates(double rollRadiansPerSecond, double pitchRadiansPerSecond, double yawRadiansPerSecond)
        => (RollRadiansPerSecond, PitchRadiansPerSecond, YawRadiansPerSecond) = (rollRadiansPerSecond, pitchRadiansPerSecond, yawRadiansPerSecond);

    /// <summary>About forward.</summary>
    public double RollRadiansPerSecond { get; }

    /// <summary>About right.</summary>
    public double PitchRadiansPerSecond { get; }

    /// <summary>About down.</summary>
    public double YawRadiansPerSecond { get; }

    /// <summary>From radians per second.</summary>
    /// <param name="rollRadiansPerSecond">About forward.</param>
    /// <param name="pitchRadiansPerSecond">About right.</param>
    /// <param name="yawRadiansPerSecond">About down.</param>
    public static BodyRates FromRadiansPerSecond(double rollRadiansPerSecond, double pitchRadiansPerSecond, double yawRadiansPerSecond)
        => new(rollRadiansPerSecond, pitchRadiansPerSecond, yawRadiansPerSecond);

    /// <summary>From degrees per second.</summary>
    /// <param name="rollDegreesPerSecond">About forward.</param>
    /// <param name="pitchDegreesPerSecond">About right.</param>
    /// <param name="yawDegreesPerSecond">About down.</param>
    public static BodyRates FromDegreesPerSecond(double rollDegreesPerSecond, double pitchDegreesPerSecond, double yawDegreesPerSecond)
        => new(Angle.FromDegrees(rollDegreesPerSecond).Radians, Angle.FromDegrees(pitchDegreesPerSecond).Radians, Angle.FromDegrees(yawDegreesPerSecond).Radians);
}
