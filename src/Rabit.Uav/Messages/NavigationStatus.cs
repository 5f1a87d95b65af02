using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>
/// How well the autopilot knows where it is, and where it would return to. Posted by Autopilot Interface until the
/// motors run. A plain value.
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

    /// <summary>When the autopilot last reported its home; null where it never did.</summary>
    public TimeSpan? HomeTime { get; set; }

    /// <summary>Where the autopilot returns to.</summary>
    public GeodeticPosition Home { get; set; }
}
