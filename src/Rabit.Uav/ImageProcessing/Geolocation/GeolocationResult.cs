using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>The place of a pixel with its covariance and the time at which it was true; or why it is not told. A plain value.</summary>
public struct GeolocationResult
{
    /// <summary>Why there is no place; none where there is one.</summary>
    public GeolocationError Refusal { get; set; }

    /// <summary>The place on the ground. Only without a refusal.</summary>
    public GeodeticPosition Position { get; set; }

    /// <summary>How uncertain it is, of what is new in each look. Only without a refusal.</summary>
    public HorizontalCovariance Covariance { get; set; }

    /// <summary>How uncertain it is, of what is the same in all looks. Only without a refusal.</summary>
    public HorizontalCovariance SystematicCovariance { get; set; }

    /// <summary>When the pixel was exposed, by the clock of the poses.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>How far the pose was drawn on beyond the newest sample; its part of the covariance grows with that.</summary>
    public TimeSpan Extrapolated { get; set; }
}
