using System;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>The state of the camera between two evaluations.</summary>
internal sealed class CameraWatch(MessageSubscriber<ImagingStatus> status)
{
    private TimeSpan? _searchSince;
    private TimeSpan? _detectorFaultTime;
    private long _detectorFaults;

    public CameraFacts Update(TimeSpan now)
    {
        status.Fetch();
        ref readonly ImagingStatus value = ref status.Value;
        _searchSince = value.Mode == ImagingMode.Search ? _searchSince ?? now : null;
        TimeSpan since = _searchSince ?? now;
        if (value.LastFrameTime is { } last && last > since)
            since = last;
        if (CameraFacts.DetectorFaultsOf(value) != _detectorFaults)
            (_detectorFaults, _detectorFaultTime) = (CameraFacts.DetectorFaultsOf(value), now);
        return new CameraFacts(value, now - since, now - _detectorFaultTime);
    }
}
