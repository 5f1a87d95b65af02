using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>What the detector of a search did, for the status and the log. One thread.</summary>
internal sealed class DetectorFigures(PictureSearch search, Action<string> log)
{
    // A detector may fail at every picture.
    private static readonly TimeSpan LogPeriod = TimeSpan.FromSeconds(1);

    private string? _logged;
    private TimeSpan _nextLog;

    /// <summary>Copies the counts; each fault is logged once in a row, and no more than one a second.</summary>
    public void ReadInto(ref ImagingStatus status, TimeSpan now)
    {
        status.DetectorFailures = search.Detector.Failures;
        status.DetectionsRefused = search.Detector.Refused;
        status.DetectionsCut = search.Detector.Cut;
        status.DetectorOverruns = search.Detector.Overruns;
        status.LastDetectorFault = search.Detector.LastFault;
        status.UnknownClasses = search.UnknownClasses;
        if (search.Detector.LastFault is not { } fault || now < _nextLog
            || string.Equals(fault, _logged, StringComparison.Ordinal))
            return;
        (_logged, _nextLog) = (fault, now + LogPeriod);
        log(fault);
    }
}
