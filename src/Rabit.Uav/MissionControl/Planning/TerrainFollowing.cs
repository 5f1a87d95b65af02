using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Heights above home that keep a height above ground: the ground of a terrain grid, raised where it is steeper than
/// the vehicle climbs and sinks. A function of the place alone, so that every path over it can be flown at the planned
/// speed. Ground is counted from the ground at home, which takes out what datum and barometer differ by. Made with a
/// plan, with the places that it leads over; not changed after that.
/// </summary>
internal sealed partial class TerrainFollowing
{
    /// <summary>Below this above home nothing is flown: autopilots take a vehicle there for landed.</summary>
    public const double MinHeightAboveHomeMetres = 5;

    // PX4's set-points sink with 1 m/s. ArduPilot has WPNAV_SPEED_UP 2.5 m/s and WPNAV_SPEED_DN 1.5 m/s.
    private const double ClimbMetresPerSecond = 1;

    // More is another place, or heights above the ellipsoid.
    private const double MaxDatumDifferenceMetres = 60;

    private const double MinCellMetres = 5;
    private const int MaxNodes = 250_000;
    private const double MetresPerDegree = 111_320;

    private readonly TerrainGrid _terrain;
    private readonly LocalNedFrame _frame;
    private readonly double _homeAmslMetres;
    private readonly PlanePoint _southWest;
    private readonly int _rows;
    private readonly int _columns;
    private readonly float[] _rise;
    private readonly float[] _ahead;
    private (double Metres, PlanePoint At) _excess = (double.NegativeInfinity, default);
    private (double Metres, PlanePoint At) _depth = (double.NegativeInfinity, default);

    private TerrainFollowing(
        TerrainGrid terrain, LocalNedFrame frame, double homeAmslMetres, PlanePolygon fence, double speed)
    {
        (_terrain, _frame, _homeAmslMetres, MaxSpeedMetresPerSecond) = (terrain, frame, homeAmslMetres, speed);
        double south = Math.Min(0, fence.Corners.Min(c => c.North));
        double west = Math.Min(0, fence.Corners.Min(c => c.East));
        double north = Math.Max(0, fence.Corners.Max(c => c.North)) - south;
        double east = Math.Max(0, fence.Corners.Max(c => c.East)) - west;
        CellMetres = Math.Max(MinCellMetres, Math.Sqrt(north * east / MaxNodes));

        // One cell more around: between its nodes the ground is below all four.
        (_southWest, _rows, _columns) = (
            new PlanePoint(south - CellMetres, west - CellMetres),
            (int)Math.Ceiling(north / CellMetres) + 3,
            (int)Math.Ceiling(east / CellMetres) + 3);
        _rise = new float[_rows * _columns];
        _ahead = new float[_rows * _columns];
    }

    /// <summary>Distance of the nodes.</summary>
    public double CellMetres { get; }

    /// <summary>Up to this speed the vehicle can follow.</summary>
    public double MaxSpeedMetresPerSecond { get; }

    /// <summary>How much the heights change, at most, over a metre of way.</summary>
    public double MaxSlope => ClimbMetresPerSecond / MaxSpeedMetresPerSecond;

    /// <summary>Prepares the heights of a region.</summary>
    /// <param name="terrain">The ground.</param>
    /// <param name="frame">Its origin is on the ground, at home.</param>
    /// <param name="fence">What is not left; with home it must be on the grid.</param>
    /// <param name="speed">Ground speed of the mission, m/s.</param>
    /// <param name="fault">Why that cannot be; empty where it can.</param>
    public static TerrainFollowing? Create(
        TerrainGrid terrain, LocalNedFrame frame, PlanePolygon fence, double speed, out string fault)
    {
        fault = FindFaultAtHome(terrain, frame, out double home) ?? string.Empty;
        if (fault.Length > 0)
            return null;
        var heights = new TerrainFollowing(terrain, frame, home, fence, speed);
        fault = heights.Sample() ?? string.Empty;
        if (fault.Length > 0)
            return null;
        heights.LimitSlope();
        heights.LookAhead();
        return heights;
    }

    /// <summary>The ground at a place, above that at home; NaN where the grid has none.</summary>
    public double GroundMetres(PlanePoint at)
    {
        if (double.IsNaN(at.North + at.East))
            return double.NaN;
        return _terrain.TryAltitude(PointAt(at), out AmslAltitude altitude) == TerrainLookup.Known
            ? altitude.Metres - _homeAmslMetres
            : double.NaN;
    }

    /// <summary>The height above home to fly at a place.</summary>
    /// <param name="at">The place; outside the region that of its border.</param>
    /// <param name="aboveGroundMetres">The height above ground that is kept.</param>
    public double HeightAboveHome(PlanePoint at, double aboveGroundMetres)
        => Math.Max(MinHeightAboveHomeMetres, aboveGroundMetres + RiseAt(at));

    /// <summary>The least height above home that is enough on the whole way between two places.</summary>
    public double HeightAboveHome(PlanePoint from, PlanePoint to, double aboveGroundMetres)
    {
        double highest = RiseAt(to);
        int steps = (int)Math.Ceiling(from.DistanceTo(to) / CellMetres);
        for (int i = 0; i < steps; i++)
            highest = Math.Max(highest, RiseAt(from + (i / (double)steps * (to - from))));
        return Math.Max(MinHeightAboveHomeMetres, aboveGroundMetres + highest);
    }

    /// <summary>How much is climbed on the way between two places, and the height above home at its end.</summary>
    public (double ClimbedMetres, double HeightMetres) ClimbBetween(
        PlanePoint from, PlanePoint to, double aboveGroundMetres)
    {
        double at = HeightAboveHome(from, aboveGroundMetres);
        double climbed = 0;
        int steps = (int)Math.Ceiling(from.DistanceTo(to) / CellMetres);
        for (int i = 1; i <= steps; i++)
        {
            double next = HeightAboveHome(from + (i / (double)steps * (to - from)), aboveGroundMetres);
            climbed += Math.Max(0, next - at);
            at = next;
        }

        return (climbed, at);
    }

    /// <summary>
    /// The largest height above ground over all places that were added, where a height is kept, and one such place: a
    /// goal that is ahead is as high as the way to it needs.
    /// </summary>
    public (double Metres, PlanePoint At) MaxHeightAboveGround(double aboveGroundMetres)
        => aboveGroundMetres + _excess.Metres > _depth.Metres
            ? (aboveGroundMetres + _excess.Metres, _excess.At)
            : _depth;

    /// <summary>Adds the nodes of an area, without those of others.</summary>
    public void AddPlaces(PlanePolygon area, IReadOnlyList<PlanePolygon> without)
    {
        for (int row = 0; row < _rows; row++)
        {
            for (int column = 0; column < _columns; column++)
            {
                PlanePoint at = NodeAt(row, column);
                if (area.Contains(at) && !without.Any(p => p.Contains(at)))
                    AddPlace(at, row, column);
            }
        }
    }

    /// <summary>Adds the nodes beside a straight way.</summary>
    public void AddPlaces(PlanePoint from, PlanePoint to)
    {
        int steps = 1 + (int)Math.Ceiling(from.DistanceTo(to) / CellMetres);
        for (int i = 0; i <= steps; i++)
        {
            PlanePoint at = from + (i / (double)steps * (to - from));
            PlanePoint cells = (1 / CellMetres) * (at - _southWest);
            AddPlace(
                at, Math.Max(0, Math.Min(_rows - 1, (int)Math.Round(cells.North))),
                Math.Max(0, Math.Min(_columns - 1, (int)Math.Round(cells.East))));
        }
    }

    private void AddPlace(PlanePoint at, int row, int column)
    {
        double ground = GroundMetres(at);
        double excess = _ahead[(row * _columns) + column] - ground;
        if (excess > _excess.Metres)
            _excess = (excess, at);
        if (MinHeightAboveHomeMetres - ground > _depth.Metres)
            _depth = (MinHeightAboveHomeMetres - ground, at);
    }

    private static string? FindFaultAtHome(TerrainGrid terrain, LocalNedFrame frame, out double homeAmslMetres)
    {
        TerrainLookup found = terrain.TryAltitude(frame.Origin.Point, out AmslAltitude home);
        homeAmslMetres = home.Metres;
        if (found != TerrainLookup.Known)
            return $"the terrain grid {TextOf(found)} home";
        double difference = Math.Abs(homeAmslMetres - frame.Origin.AltitudeAmslMetres);
        return difference <= MaxDatumDifferenceMetres
            ? null
            : $"the ground at home is at {MissionNumbers.Of(frame.Origin.AltitudeAmslMetres)} m above mean sea level "
                + $"according to the vehicle, at {MissionNumbers.Of(homeAmslMetres)} m according to the terrain grid; "
                + $"they may differ by {MissionNumbers.Of(MaxDatumDifferenceMetres)} m";
    }

    private static string TextOf(TerrainLookup found)
        => found == TerrainLookup.Outside ? "does not cover" : "has no altitude of";

    private PlanePoint NodeAt(int row, int column)
        => _southWest + new PlanePoint(row * CellMetres, column * CellMetres);

    private GeographicPoint PointAt(PlanePoint at)
        => _frame.ToGeodetic(new NedPosition(at.North, at.East, 0)).Point;

    private double RiseAt(PlanePoint at)
    {
        PlanePoint cells = (1 / CellMetres) * (at - _southWest);
        double row = Math.Max(0, Math.Min(_rows - 1, cells.North));
        double column = Math.Max(0, Math.Min(_columns - 1, cells.East));
        int south = Math.Min((int)row, _rows - 2);
        int west = Math.Min((int)column, _columns - 2);
        (double v, double u) = (row - south, column - west);
        int first = (south * _columns) + west;
        double southern = ((1 - u) * _rise[first]) + (u * _rise[first + 1]);
        double northern = ((1 - u) * _rise[first + _columns]) + (u * _rise[first + _columns + 1]);
        return ((1 - v) * southern) + (v * northern);
    }
}
