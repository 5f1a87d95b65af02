using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>
/// How well the autopilot knows where it is, and where it would return to. Posted by Autopilot Interface whenever the
/// autopilot reports of it. A plain value.
/// </summary>
public struct NavigationStatus
{
    /// <summary>When the satellite receiver last reported; null before the first.</summary>
    public TimeSpan? DilutionTime { get; set; }

    /// <summary>Horizontal dilution of precision (HDOP), no unit; NaN where the receiver does not know it.</summary>
    public double HorizontalDilution { get; set; }

    /// <summary>When the estimator last reported; null where it never did.</summary>
    public TimeSpan? EstimatorTime { get; set; }

    /// <summary>
    /// What is wrong with the estimate of attitude, velocity and position, as text; null where nothing is.
    /// </summary>
    public string? EstimatorFault { get; set; }

    /// <summary>
    /// The greatest of what the estimator reports of velocity, horizontal position and height against their
    /// measurements, no unit: 1 is where a measurement is rejected (ArduPilot's "variances", PX4's innovation test
    /// ratios); NaN where it reports none of them.
    /// </summary>
    public double EstimatorRatio { get; set; }

    /// <summary>When the air pressure was measured; null where it is not reported.</summary>
    public TimeSpan? PressureTime { get; set; }

    /// <summary>
    /// Height of the air pressure in the standard atmosphere (ISO 2533), metres above the level of 1013.25 hPa: its
    /// changes are changes of height, itself it says nothing.
    /// </summary>
    public double PressureHeightMetres { get; set; }

    /// <summary>When the autopilot last reported its home; null where it never did.</summary>
    public TimeSpan? HomeTime { get; set; }

    /// <summary>Where the autopilot returns to.</summary>
    public GeodeticPosition Home { get; set; }
}
