namespace Rabit.Uav.MissionControl;

/// <summary>Home: where a mission expects the vehicle at the start. Immutable.</summary>
public sealed class MissionHome
{
    /// <summary>Latitude, radians, north positive.</summary>
    public double LatitudeRadians { get; init; }

    /// <summary>Longitude, radians, east positive.</summary>
    public double LongitudeRadians { get; init; }

    /// <summary>
    /// Altitude of the ground there, metres above mean sea level; null where it is not known. A check: the altitude
    /// that the vehicle reports is the one used.
    /// </summary>
    public double? GroundAltitudeAmslMetres { get; init; }
}
