using Rabit.Geodesy;

namespace Rabit.Uav.MissionControl;

/// <summary>Home: where a mission expects the vehicle at the start. Immutable.</summary>
public sealed class MissionHome
{
    /// <summary>Latitude, north positive.</summary>
    public Angle Latitude { get; init; }

    /// <summary>Longitude, east positive.</summary>
    public Angle Longitude { get; init; }

    /// <summary>
    /// Altitude of the ground there, metres above mean sea level; null where it is not known. A check: the altitude
    /// that the vehicle reports is the one used.
    /// </summary>
    public double? GroundAltitudeAmslMetres { get; init; }
}
