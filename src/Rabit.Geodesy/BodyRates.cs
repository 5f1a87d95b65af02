using System;

namespace Rabit.Geodesy;

/// <summary>
/// Angular velocity in the body frame (forward-right-down). A plain value, made from numbers by a method that names the
/// unit. Rates are not angles: they are numbers whose names say radians per second.
/// </summary>
public readonly record struct BodyRates
{
    private BodyRates(double rollRadiansPerSecond, double pitchRadiansPerSecond, double yawRadiansPerSecond)
        => (RollRadiansPerSecond, PitchRadiansPerSecond, YawRadiansPerSecond) =
            (rollRadiansPerSecond, pitchRadiansPerSecond, yawRadiansPerSecond);

    /// <summary>About forward.</summary>
    public double RollRadiansPerSecond { get; }

    /// <summary>About right.</summary>
    public double PitchRadiansPerSecond { get; }

    /// <summary>About down.</summary>
    public double YawRadiansPerSecond { get; }

    /// <summary>Whether all three are numbers, and not infinite ones.</summary>
    public bool IsFinite => FiniteNumbers.AreFinite(RollRadiansPerSecond, PitchRadiansPerSecond, YawRadiansPerSecond);

    /// <summary>From radians per second.</summary>
    /// <param name="rollRadiansPerSecond">About forward.</param>
    /// <param name="pitchRadiansPerSecond">About right.</param>
    /// <param name="yawRadiansPerSecond">About down.</param>
    public static BodyRates FromRadiansPerSecond(
        double rollRadiansPerSecond, double pitchRadiansPerSecond, double yawRadiansPerSecond)
        => new(rollRadiansPerSecond, pitchRadiansPerSecond, yawRadiansPerSecond);

    /// <summary>From degrees per second.</summary>
    /// <param name="rollDegreesPerSecond">About forward.</param>
    /// <param name="pitchDegreesPerSecond">About right.</param>
    /// <param name="yawDegreesPerSecond">About down.</param>
    public static BodyRates FromDegreesPerSecond(
        double rollDegreesPerSecond, double pitchDegreesPerSecond, double yawDegreesPerSecond)
        => new(
            rollDegreesPerSecond * Angle.RadiansPerDegree, pitchDegreesPerSecond * Angle.RadiansPerDegree,
            yawDegreesPerSecond * Angle.RadiansPerDegree);

    /// <summary>As (0.1, 0, -0.02) rad/s.</summary>
    public override string ToString()
        => FormattableString.Invariant(
            $"({RollRadiansPerSecond:0.####}, {PitchRadiansPerSecond:0.####}, {YawRadiansPerSecond:0.####}) rad/s");
}
