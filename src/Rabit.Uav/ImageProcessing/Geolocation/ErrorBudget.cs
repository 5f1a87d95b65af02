using System;
using System.Collections.Generic;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// How wrong the things are from which a position on the ground is reckoned, one standard deviation each. What is new in every look
/// makes the covariance of a report; what stays for a flight makes its common covariance.
/// </summary>
public sealed class ErrorBudget
{
    private const double Degree = Math.PI / 180;

    /// <summary>Roll and pitch, anew in each look, radians.</summary>
    /// <value>The default is 0.3 degrees.</value>
    public double AttitudeNoiseRadians { get; set; } = 0.3 * Degree;

    /// <summary>Heading, anew in each look, radians.</summary>
    /// <value>The default is 0.5 degrees.</value>
    public double HeadingNoiseRadians { get; set; } = 0.5 * Degree;

    /// <summary>Horizontal position of the vehicle, each axis, anew in each look, metres.</summary>
    /// <value>The default is 0.3 m.</value>
    public double PositionNoiseMetres { get; set; } = 0.3;

    /// <summary>Altitude of the vehicle, anew in each look, metres.</summary>
    /// <value>The default is 0.3 m.</value>
    public double AltitudeNoiseMetres { get; set; } = 0.3;

    /// <summary>Centre of a target in the picture, each axis, pixels.</summary>
    /// <value>The default is 0.5 pixels.</value>
    public double PixelNoise { get; set; } = 0.5;

    /// <summary>Time of the picture against that of the poses.</summary>
    /// <value>The default is 10 ms.</value>
    public TimeSpan TimeNoise { get; set; } = TimeSpan.FromMilliseconds(10);

    /// <summary>Roll and pitch, the same in all looks, radians.</summary>
    /// <value>The default is 0.7 degrees: a vehicle that was levelled, but not calibrated with its camera.</value>
    public double AttitudeBiasRadians { get; set; } = 0.7 * Degree;

    /// <summary>Heading, the same in all looks, radians.</summary>
    /// <value>The default is 1 degree: a compass.</value>
    public double HeadingBiasRadians { get; set; } = 1 * Degree;

    /// <summary>Each angle of the camera mount, the same in all looks, radians.</summary>
    /// <value>The default is 0.3 degrees.</value>
    public double MountBiasRadians { get; set; } = 0.3 * Degree;

    /// <summary>Horizontal position of the vehicle, each axis, the same in all looks, metres.</summary>
    /// <value>The default is 1.1 m: satellite navigation without correction data over some minutes.</value>
    public double PositionBiasMetres { get; set; } = 1.1;

    /// <summary>Altitude of the vehicle above the ground, the same in all looks, metres: of the position and of the ground together.</summary>
    /// <value>The default is 1.3 m.</value>
    public double AltitudeBiasMetres { get; set; } = 1.3;

    /// <summary>How fast the vehicle may change its velocity, metres per second squared: a pose that is drawn on by t is wrong by half of it times t squared.</summary>
    /// <value>The default is 3 m/s2.</value>
    public double AccelerationMetresPerSecondSquared { get; set; } = 3;

    /// <summary>How fast the vehicle may change its rates of turn, radians per second squared, with the same effect.</summary>
    /// <value>The default is 90 degrees/s2.</value>
    public double AngularAccelerationRadiansPerSecondSquared { get; set; } = 90 * Degree;

    internal IEnumerable<string> FindFaults()
    {
        (string Name, double Value)[] figures =
        [
            (nameof(AttitudeNoiseRadians), AttitudeNoiseRadians), (nameof(HeadingNoiseRadians), HeadingNoiseRadians),
            (nameof(PositionNoiseMetres), PositionNoiseMetres), (nameof(AltitudeNoiseMetres), AltitudeNoiseMetres),
            (nameof(PixelNoise), PixelNoise), (nameof(TimeNoise), TimeNoise.TotalSeconds),
            (nameof(AttitudeBiasRadians), AttitudeBiasRadians), (nameof(HeadingBiasRadians), HeadingBiasRadians),
            (nameof(MountBiasRadians), MountBiasRadians), (nameof(PositionBiasMetres), PositionBiasMetres),
            (nameof(AltitudeBiasMetres), AltitudeBiasMetres),
            (nameof(AccelerationMetresPerSecondSquared), AccelerationMetresPerSecondSquared),
            (nameof(AngularAccelerationRadiansPerSecondSquared), AngularAccelerationRadiansPerSecondSquared),
        ];
        foreach ((string name, double value) in figures)
        {
            if (!(value >= 0) || double.IsInfinity(value))
                yield return FormattableString.Invariant($"{nameof(ErrorBudget)}.{name} is {value}; it must not be negative");
        }
    }

    internal ErrorBudget Copy() => (ErrorBudget)MemberwiseClone();
}
