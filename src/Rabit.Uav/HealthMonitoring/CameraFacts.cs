using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Input of the rules for the camera.</summary>
internal readonly struct CameraFacts(in ImagingStatus status, TimeSpan quietFor)
{
    public ImagingStatus Status { get; } = status;

    /// <summary>Since its last picture, or since the search began, whichever is later.</summary>
    public TimeSpan QuietFor { get; } = quietFor;
}
