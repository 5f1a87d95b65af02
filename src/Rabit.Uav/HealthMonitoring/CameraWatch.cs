using System;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>The state of the camera between two evaluations.</summary>
internal sealed class CameraWatch(MessageSubscriber<ImagingStatus> status)
{
    // A fault that comes and goes is one fault: on the way back to the lane, say, or blur that ends while it hovers.
    private static readonly TimeSpan UsableToForget = TimeSpan.FromSeconds(30);

    private const int ShareSteps = 4;
    private const int PercentPerStep = 100 / ShareSteps;

    private TimeSpan? _searchSince;
    private TimeSpan? _stuckAt;
    private TimeSpan? _detectorFaultTime;
    private TimeSpan _lastUpdate;
    private TimeSpan _unusableFor;
    private TimeSpan _usableFor;
    private long _detectorFaults;
    private long _unusableFigure;

    /// <summary>Updates it; once in each evaluation.</summary>
    /// <param name="now">The time of the evaluation.</param>
    /// <param name="isProcessingStuck">
    /// Whether Image Processing is stuck: then its silence says nothing of the camera.
    /// </param>
    /// <param name="options">The thresholds.</param>
    public CameraFacts Update(TimeSpan now, bool isProcessingStuck, HealthOptions options)
    {
        status.Fetch();
        ref readonly ImagingStatus value = ref status.Value;
        _searchSince = value.Mode != ImagingMode.Off ? _searchSince ?? now : null;
        _stuckAt = isProcessingStuck ? now : _stuckAt;
        TimeSpan since = _searchSince ?? now;
        if (value.LastFrameTime is { } last && last > since)
            since = last;
        if (_stuckAt is { } stuck && stuck > since)
            since = stuck;
        if (CameraFacts.DetectorFaultsOf(value) != _detectorFaults)
            (_detectorFaults, _detectorFaultTime) = (CameraFacts.DetectorFaultsOf(value), now);
        CountUnusable(value, now - _lastUpdate, options);
        _lastUpdate = now;
        return new CameraFacts(value, now - since, now - _detectorFaultTime, _unusableFor, _unusableFigure);
    }

    private void CountUnusable(in ImagingStatus imaging, TimeSpan elapsed, HealthOptions options)
    {
        if (imaging.UsableShare is not { } share || imaging.Mode == ImagingMode.Follow)
            return;
        if (share <= options.PicturesUsableFraction)
        {
            (_unusableFor, _usableFor) = (_unusableFor + elapsed, TimeSpan.Zero);
            _unusableFigure = ((long)imaging.UnusableCause * CameraFacts.CauseUnit)
                + (PercentPerStep * (long)Math.Round(ShareSteps * imaging.UnusableCauseShare));
        }
        else
        {
            _usableFor += elapsed;
        }

        if (_usableFor >= UsableToForget)
            _unusableFor = TimeSpan.Zero;
    }
}
