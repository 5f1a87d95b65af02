using System;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Whether the vehicle is outside the fence or beyond its limits of height and distance, for longer than an outlier.
/// </summary>
internal sealed class MissionLimits
{
    // A single position outside may be an outlier.
    private static readonly TimeSpan MaxTimeOutside = TimeSpan.FromSeconds(1);

    private TimeSpan? _outsideSince;

    public void Reset() => _outsideSince = null;

    /// <summary>Which limit is exceeded; null where none is, or not for long enough.</summary>
    public string? Find(MissionFlight flight)
    {
        bool isOutside = IsOutside(flight);
        _outsideSince = isOutside ? _outsideSince ?? flight.Now : null;
        return flight.Now - _outsideSince >= MaxTimeOutside ? Describe(flight) : null;
    }

    private static bool IsOutside(MissionFlight flight)
        => flight.HeightAboveGroundMetres > flight.Mission.MaxHeightMetres
            || (flight.Plan is { } plan
                && (plan.InsideMetres(flight.Position) < 0
                    || flight.DistanceFromHomeMetres > flight.Mission.MaxDistanceMetres));

    private static string Describe(MissionFlight flight)
    {
        if (flight.HeightAboveGroundMetres > flight.Mission.MaxHeightMetres)
        {
            string ground = flight.Plan?.Terrain is null ? string.Empty : " above ground";
            return $"height {MissionNumbers.Of(flight.HeightAboveGroundMetres)} m{ground}, above the limit of "
                + $"{MissionNumbers.Of(flight.Mission.MaxHeightMetres.Value)} m";
        }

        if (flight.DistanceFromHomeMetres > flight.Mission.MaxDistanceMetres)
        {
            return $"{MissionNumbers.Of(flight.DistanceFromHomeMetres)} m from home, beyond the limit of "
                + $"{MissionNumbers.Of(flight.Mission.MaxDistanceMetres.Value)} m";
        }

        if (flight.Plan!.Fence.SignedDistance(flight.Position) > 0)
            return $"{MissionNumbers.Of(-flight.Plan.InsideMetres(flight.Position))} m inside a keep-out";
        return $"{MissionNumbers.Of(-flight.Plan.Fence.SignedDistance(flight.Position))} m outside the fence";
    }
}
