using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// The place of a pixel with its covariance and the time at which it was true; or why there is none. A plain value.
/// </summary>
public struct GeolocationResult
{
    /// <summary>Why there is no place; none where there is one.</summary>
    public GeolocationError Error { get; set; }

    /// <summary>The place on the ground. Only without an error.</summary>
    public GeodeticPosition Position { get; set; }

    /// <summary>How uncertain it is, by random errors, new in each observation. Only without an error.</summary>
    public HorizontalCovariance Covariance { get; set; }

    /// <summary>
    /// How uncertain it is, by systematic errors, the same in all observations. Only without an error.
    /// </summary>
    public HorizontalCovariance SystematicCovariance { get; set; }

    /// <summary>When the pixel was exposed, by the clock of the poses.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>
    /// How far the pose was extrapolated beyond the newest sample; its part of the covariance grows with that.
    /// </summary>
    public TimeSpan Extrapolated { get; set; }
}
