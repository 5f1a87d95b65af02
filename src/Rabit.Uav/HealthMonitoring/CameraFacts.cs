using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Input of the rules for the camera.</summary>
internal readonly struct CameraFacts(
    in ImagingStatus status, TimeSpan quietFor, TimeSpan? detectorFaultAge, TimeSpan unusableFor = default,
    long unusableFigure = 0)
{
    /// <summary>Of <see cref="UnusableFigure"/>: so many for each cause.</summary>
    public const int CauseUnit = 1000;

    public ImagingStatus Status { get; } = status;

    /// <summary>
    /// Since its last picture, since the search began, or since Image Processing was stuck, whichever is later.
    /// </summary>
    public TimeSpan QuietFor { get; } = quietFor;

    /// <summary>Since a fault of the detector was last counted; null where none was.</summary>
    public TimeSpan? DetectorFaultAge { get; } = detectorFaultAge;

    /// <summary>
    /// For how long pictures have been unusable in all, without the time in which they were not; zero again once they
    /// were usable for long.
    /// </summary>
    public TimeSpan UnusableFor { get; } = unusableFor;

    /// <summary>
    /// Why pictures were unusable last, and how many of them for that reason, per cent in quarters: it stays the same
    /// while one picture comes and goes.
    /// </summary>
    public long UnusableFigure { get; } = unusableFigure;

    /// <summary>What the detector did wrong so far: failures, invalid detections, overruns.</summary>
    public long DetectorFaults => DetectorFaultsOf(Status);

    public static long DetectorFaultsOf(in ImagingStatus status)
        => status.DetectorFailures + status.DetectionsRefused + status.DetectorOverruns;
}
