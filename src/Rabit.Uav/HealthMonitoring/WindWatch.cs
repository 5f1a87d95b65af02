using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Remembers since when the wind has been too strong.</summary>
internal sealed class WindWatch
{
    // Told once a second; what is older says nothing of now.
    private static readonly TimeSpan FreshFor = TimeSpan.FromSeconds(5);

    private TimeSpan? _highSince;

    /// <returns>For how long it has been; null while it is not, or is not known.</returns>
    public TimeSpan? Look(in VehicleState vehicle, TimeSpan now, HealthOptions options)
    {
        bool isHigh = vehicle.WindTime is { } time && now - time <= FreshFor && vehicle.WindMetresPerSecond > options.WindHigh;
        _highSince = isHigh ? _highSince ?? now : null;
        return now - _highSince;
    }
}
