using System;
using System.Collections.Generic;

namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>What is known before a <see cref="BiasEstimator"/> sees a look: one standard deviation each. Zero: it is right, and not estimated.</summary>
public sealed class BiasOptions
{
    private const double Degree = Math.PI / 180;

    /// <summary>Each angle of the mount, radians.</summary>
    /// <value>The default is 3 degrees.</value>
    public double MountRadians { get; set; } = 3 * Degree;

    /// <summary>Roll and pitch of the autopilot, radians.</summary>
    /// <value>The default is 0.7 degrees.</value>
    public double AttitudeRadians { get; set; } = 0.7 * Degree;

    /// <summary>Heading of the autopilot, radians.</summary>
    /// <value>The default is 1 degree.</value>
    public double HeadingRadians { get; set; } = 1 * Degree;

    /// <summary>Time of the pictures against the poses'.</summary>
    /// <value>The default is 20 ms.</value>
    public TimeSpan Time { get; set; } = TimeSpan.FromMilliseconds(20);

    /// <summary>Position of the vehicle, each horizontal axis, metres.</summary>
    /// <value>The default is 1.5 m.</value>
    public double PositionMetres { get; set; } = 1.5;

    /// <summary>Height of the vehicle above the ground, metres.</summary>
    /// <value>The default is 2 m.</value>
    public double HeightMetres { get; set; } = 2;

    /// <summary>Attitude, each angle, anew in each look, radians.</summary>
    /// <value>The default is 0.3 degrees.</value>
    public double AttitudeNoiseRadians { get; set; } = 0.3 * Degree;

    /// <summary>Position, each axis, anew in each look, metres.</summary>
    /// <value>The default is 0.3 m.</value>
    public double PositionNoiseMetres { get; set; } = 0.3;

    /// <summary>Place in the picture, each axis, anew in each look, pixels.</summary>
    /// <value>The default is 0.5 pixels.</value>
    public double PixelNoise { get; set; } = 0.5;

    /// <summary>For how long the noise of attitude and position stays alike; looks that are close together tell less than their number says.</summary>
    /// <value>The default is 0.5 s.</value>
    public TimeSpan NoiseTime { get; set; } = TimeSpan.FromSeconds(0.5);

    internal double[] Sigmas() =>
    [
        MountRadians, MountRadians, MountRadians, AttitudeRadians, AttitudeRadians, HeadingRadians, Time.TotalSeconds,
        PositionMetres, PositionMetres, HeightMetres,
    ];

    internal IEnumerable<string> FindFaults()
    {
        (string Name, double Value)[] figures =
        [
            (nameof(MountRadians), MountRadians), (nameof(AttitudeRadians), AttitudeRadians), (nameof(HeadingRadians), HeadingRadians),
            (nameof(Time), Time.TotalSeconds), (nameof(PositionMetres), PositionMetres), (nameof(HeightMetres), HeightMetres),
            (nameof(AttitudeNoiseRadians), AttitudeNoiseRadians), (nameof(PositionNoiseMetres), PositionNoiseMetres),
            (nameof(NoiseTime), NoiseTime.TotalSeconds),
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
