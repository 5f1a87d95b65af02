using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>What the rules judge the camera by.</summary>
internal readonly struct CameraFacts(in ImagingStatus status, TimeSpan quietFor)
{
    public ImagingStatus Status { get; } = status;

    /// <summary>Since its last picture, or since it was told to search, whichever came later.</summary>
    public TimeSpan QuietFor { get; } = quietFor;
}
