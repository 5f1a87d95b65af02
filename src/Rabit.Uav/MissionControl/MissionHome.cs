namespace Rabit.Uav.MissionControl;

/// <summary>Where a mission expects the vehicle to stand at the start. Immutable.</summary>
public sealed class MissionHome
{
    /// <summary>Latitude, radians, north positive.</summary>
    public double LatitudeRadians { get; init; }

    /// <summary>Longitude, radians, east positive.</summary>
    public double LongitudeRadians { get; init; }

    /// <summary>Altitude of the ground there, metres above mean sea level; null where it is not known. It is a check: the vehicle's own is used.</summary>
    public double? GroundAltitudeAmslMetres { get; init; }
}
