using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Since when the wind has been above its limit.</summary>
internal sealed class WindWatch
{
    // Reported once a second; an older estimate is out of date.
    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(5);

    private TimeSpan? _highSince;

    /// <returns>For how long it has been; null while it is not, or is unknown.</returns>
    public TimeSpan? Update(in VehicleState vehicle, TimeSpan now, HealthOptions options)
    {
        bool isHigh = vehicle.WindTime is { } time && now - time <= MaxAge
            && vehicle.WindMetresPerSecond > options.WindHighMetresPerSecond;
        _highSince = isHigh ? _highSince ?? now : null;
        return now - _highSince;
    }
}
