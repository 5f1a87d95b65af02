using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// The error budget of geolocation: how wrong the things are from which a position on the ground is computed, one
/// standard deviation each. Random errors (noise) are new in every observation and make the covariance of a report;
/// systematic ones (biases) stay for a flight and make its systematic covariance.
/// </summary>
public sealed class ErrorBudget
{
    /// <summary>Roll and pitch, new in each observation.</summary>
    /// <value>The default is 0.3 degrees.</value>
    public Angle AttitudeNoise { get; set; } = Angle.FromDegrees(0.3);

    /// <summary>Heading, new in each observation.</summary>
    /// <value>The default is 0.5 degrees.</value>
    public Angle HeadingNoise { get; set; } = Angle.FromDegrees(0.5);

    /// <summary>Horizontal position of the vehicle, each axis, new in each observation, metres.</summary>
    /// <value>The default is 0.3 m.</value>
    public double PositionNoiseMetres { get; set; } = 0.3;

    /// <summary>Altitude of the vehicle, new in each observation, metres.</summary>
    /// <value>The default is 0.3 m.</value>
    public double AltitudeNoiseMetres { get; set; } = 0.3;

    /// <summary>Centre of a target in the picture, each axis, pixels.</summary>
    /// <value>The default is 0.5 pixels.</value>
    public double PixelNoise { get; set; } = 0.5;

    /// <summary>
    /// Time of the picture against that of the poses. What a picture says of its own time
    /// (<c>CameraFrame.TimeNoise</c>) is added as an independent error.
    /// </summary>
    /// <value>The default is 10 ms.</value>
    public TimeSpan TimeNoise { get; set; } = TimeSpan.FromMilliseconds(10);

    /// <summary>Roll and pitch, the same in all observations.</summary>
    /// <value>The default is 0.7 degrees: a vehicle that was levelled, but not calibrated with its camera.</value>
    public Angle AttitudeBias { get; set; } = Angle.FromDegrees(0.7);

    /// <summary>Heading, the same in all observations.</summary>
    /// <value>The default is 1 degree: a compass.</value>
    public Angle HeadingBias { get; set; } = Angle.FromDegrees(1);

    /// <summary>Each angle of the camera mount, the same in all observations.</summary>
    /// <value>The default is 0.3 degrees.</value>
    public Angle MountBias { get; set; } = Angle.FromDegrees(0.3);

    /// <summary>Focal length, the same in all observations, as a part of it.</summary>
    /// <value>
    /// The default is 0: what a camera is known by says its own error (<see cref="CameraModel.FocalLengthError"/>),
    /// which is added as an independent one.
    /// </value>
    public double FocalLengthBias { get; set; }

    /// <summary>Horizontal position of the vehicle, each axis, the same in all observations, metres.</summary>
    /// <value>The default is 1.1 m: satellite navigation without correction data over some minutes.</value>
    public double PositionBiasMetres { get; set; } = 1.1;

    /// <summary>
    /// Altitude of the vehicle above the ground, the same in all observations, metres: of the position and of the
    /// ground together.
    /// </summary>
    /// <value>The default is 1.3 m.</value>
    public double AltitudeBiasMetres { get; set; } = 1.3;

    /// <summary>
    /// How fast the vehicle may change its velocity, metres per second squared: a pose that is extrapolated by t is
    /// wrong by half of it times t squared.
    /// </summary>
    /// <value>The default is 3 m/s2.</value>
    public double AccelerationMetresPerSecondSquared { get; set; } = 3;

    /// <summary>
    /// How fast the vehicle may change its rates of turn, radians per second squared, with the same effect.
    /// </summary>
    /// <value>The default is 90 degrees/s2.</value>
    public double AngularAccelerationRadiansPerSecondSquared { get; set; } = 90 * Angle.RadiansPerDegree;

    internal IEnumerable<string> FindFaults()
    {
        (string Name, double Value)[] figures =
        [
            (nameof(AttitudeNoise), AttitudeNoise.Degrees), (nameof(HeadingNoise), HeadingNoise.Degrees),
            (nameof(PositionNoiseMetres), PositionNoiseMetres), (nameof(AltitudeNoiseMetres), AltitudeNoiseMetres),
            (nameof(PixelNoise), PixelNoise), (nameof(TimeNoise), TimeNoise.ExactSeconds),
            (nameof(AttitudeBias), AttitudeBias.Degrees), (nameof(HeadingBias), HeadingBias.Degrees),
            (nameof(MountBias), MountBias.Degrees), (nameof(FocalLengthBias), FocalLengthBias),
            (nameof(PositionBiasMetres), PositionBiasMetres),
            (nameof(AltitudeBiasMetres), AltitudeBiasMetres),
            (nameof(AccelerationMetresPerSecondSquared), AccelerationMetresPerSecondSquared),
            (nameof(AngularAccelerationRadiansPerSecondSquared), AngularAccelerationRadiansPerSecondSquared),
        ];
        foreach ((string name, double value) in figures)
        {
            if (!(value >= 0) || double.IsInfinity(value))
                yield return FormattableString.Invariant(
                    $"{nameof(ErrorBudget)}.{name} is {value}; it must not be negative");
        }
    }

    internal ErrorBudget Copy() => (ErrorBudget)MemberwiseClone();
}
