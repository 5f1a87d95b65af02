using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;

namespace Rabit.Uav.Preflight;

/// <summary>The highest ground that a straight way home from a search may lead over. One thread.</summary>
/// <param name="terrain">The ground.</param>
/// <param name="area">Corners of the area that is searched.</param>
/// <param name="marginMetres">How far outside it the vehicle may be.</param>
internal sealed class ReturnTerrain(TerrainGrid terrain, IReadOnlyList<GeodeticPosition> area, double marginMetres)
{
    // Nearer than this it is the same home.
    private const double SameMetres = 5;

    private GeodeticPosition? _home;
    private double? _highest;

    /// <summary>Its height above that at home, metres; null where the grid does not cover the way.</summary>
    /// <param name="home">Where the vehicle stands.</param>
    public double? MaxAboveHomeMetres(GeodeticPosition home)
    {
        if (_home is { } known
            && LocalNedFrame.IgnoringGeoid(known).ToNed(home).HorizontalDistanceTo(default) <= SameMetres)
            return _highest;
        (_home, _highest) = (home, Find(home));
        return _highest;
    }

    private double? Find(GeodeticPosition home)
    {
        var frame = LocalNedFrame.IgnoringGeoid(home);
        NedPosition[] corners = [.. area.Select(c => frame.ToNed(c)), default];
        GeographicPoint southWest = PointAt(
            corners.Min(c => c.North) - marginMetres, corners.Min(c => c.East) - marginMetres);
        GeographicPoint northEast = PointAt(
            corners.Max(c => c.North) + marginMetres, corners.Max(c => c.East) + marginMetres);
        if (terrain.TryAltitude(home.Point, out AmslAltitude ground) != TerrainLookup.Known
            || terrain.TryMaxAltitude(southWest, northEast, out AmslAltitude highest) != TerrainLookup.Known)
            return null;
        return highest.Metres - ground.Metres;

        GeographicPoint PointAt(double north, double east) => frame.ToGeodetic(new NedPosition(north, east, 0)).Point;
    }
}
