using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Input of the rules for the camera.</summary>
internal readonly struct CameraFacts(in ImagingStatus status, TimeSpan quietFor, TimeSpan? detectorFaultAge)
{
    public ImagingStatus Status { get; } = status;

    /// <summary>Since its last picture, or since the search began, whichever is later.</summary>
    public TimeSpan QuietFor { get; } = quietFor;

    /// <summary>Since a fault of the detector was last counted; null where none was.</summary>
    public TimeSpan? DetectorFaultAge { get; } = detectorFaultAge;

    /// <summary>What the detector did wrong so far: failures, invalid detections, overruns.</summary>
    public long DetectorFaults => DetectorFaultsOf(Status);

    public static long DetectorFaultsOf(in ImagingStatus status)
        => status.DetectorFailures + status.DetectionsRefused + status.DetectorOverruns;
}
