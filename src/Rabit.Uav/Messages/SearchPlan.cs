using System.Collections.Immutable;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>The plan of a search: area, geofence, lanes and home. Immutable.</summary>
public sealed class SearchPlan
{
    /// <summary>Name of the mission.</summary>
    public string Name { get; init; } = string.Empty;

    /// <summary>
    /// Corners of the area to search, in order, the first not repeated; altitudes are those of the ground.
    /// </summary>
    public ImmutableArray<GeodeticPosition> Area { get; init; } = [];

    /// <summary>
    /// Corners of the geofence, which the vehicle may not leave, in order; altitudes are those of the ground.
    /// </summary>
    public ImmutableArray<GeodeticPosition> Fence { get; init; } = [];

    /// <summary>
    /// Polygons that the vehicle does not enter and that are not searched, each with its corners in order.
    /// </summary>
    public ImmutableArray<ImmutableArray<GeodeticPosition>> KeepOuts { get; init; } = [];

    /// <summary>
    /// Ends of the lanes: start of the first, its end, start of the second, and so on. Altitudes are those to be flown.
    /// </summary>
    public ImmutableArray<GeodeticPosition> Lanes { get; init; } = [];

    /// <summary>Where the flight begins and ends; its altitude is that of the ground, above mean sea level.</summary>
    public GeodeticPosition Home { get; init; }

    /// <summary>
    /// Height of the search above home, metres; above ground where the mission follows terrain:
    /// <see cref="Lanes"/> has the altitudes.
    /// </summary>
    public double HeightAboveHomeMetres { get; init; }

    /// <summary>Ground speed on the lanes, metres per second.</summary>
    public double SpeedMetresPerSecond { get; init; }
}
