using System;
using System.Collections.Generic;
using Rabit.Geodesy;

namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>
/// The priors of a <see cref="BiasEstimator"/>, and the noise of its observations: one standard deviation each. Zero:
/// it is right, and not estimated.
/// </summary>
public sealed class BiasOptions
{
    /// <summary>Each angle of the mount.</summary>
    /// <value>The default is 3 degrees.</value>
    public Angle Mount { get; set; } = Angle.FromDegrees(3);

    /// <summary>Roll and pitch of the autopilot.</summary>
    /// <value>The default is 0.7 degrees.</value>
    public Angle Attitude { get; set; } = Angle.FromDegrees(0.7);

    /// <summary>Heading of the autopilot.</summary>
    /// <value>The default is 1 degree.</value>
    public Angle Heading { get; set; } = Angle.FromDegrees(1);

    /// <summary>Time of the pictures against the poses'.</summary>
    /// <value>The default is 20 ms.</value>
    public TimeSpan Time { get; set; } = TimeSpan.FromMilliseconds(20);

    /// <summary>Position of the vehicle, each horizontal axis, metres.</summary>
    /// <value>The default is 1.5 m.</value>
    public double PositionMetres { get; set; } = 1.5;

    /// <summary>Height of the vehicle above the ground, metres.</summary>
    /// <value>The default is 2 m.</value>
    public double HeightMetres { get; set; } = 2;

    /// <summary>Attitude, each angle, new in each observation.</summary>
    /// <value>The default is 0.3 degrees.</value>
    public Angle AttitudeNoise { get; set; } = Angle.FromDegrees(0.3);

    /// <summary>Position, each axis, new in each observation, metres.</summary>
    /// <value>The default is 0.3 m.</value>
    public double PositionNoiseMetres { get; set; } = 0.3;

    /// <summary>Place in the picture, each axis, new in each observation, pixels.</summary>
    /// <value>The default is 0.5 pixels.</value>
    public double PixelNoise { get; set; } = 0.5;

    /// <summary>
    /// For how long the noise of attitude and position stays alike; observations that are close together count for less
    /// than their number.
    /// </summary>
    /// <value>The default is 0.5 s.</value>
    public TimeSpan NoiseTime { get; set; } = TimeSpan.OfSeconds(0.5);

    internal double[] Sigmas() =>
    [
        Mount.Radians, Mount.Radians, Mount.Radians, Attitude.Radians, Attitude.Radians, Heading.Radians,
        Time.ExactSeconds, PositionMetres, PositionMetres, HeightMetres,
    ];

    internal IEnumerable<string> FindFaults()
    {
        (string Name, double Value)[] figures =
        [
            (nameof(Mount), Mount.Degrees), (nameof(Attitude), Attitude.Degrees), (nameof(Heading), Heading.Degrees),
            (nameof(Time), Time.ExactSeconds), (nameof(PositionMetres), PositionMetres),
            (nameof(HeightMetres), HeightMetres),
            (nameof(AttitudeNoise), AttitudeNoise.Degrees), (nameof(PositionNoiseMetres), PositionNoiseMetres),
            (nameof(NoiseTime), NoiseTime.ExactSeconds),
        ];
        foreach ((string name, double value) in figures)
        {
            if (!(value >= 0) || double.IsInfinity(value))
                yield return FormattableString.Invariant($"{name} is {value}; it must not be negative");
        }

        if (!(PixelNoise > 0) || double.IsInfinity(PixelNoise))
            yield return FormattableString.Invariant($"{nameof(PixelNoise)} is {PixelNoise}; it must be above 0");
    }

    internal BiasOptions Copy() => (BiasOptions)MemberwiseClone();
}
