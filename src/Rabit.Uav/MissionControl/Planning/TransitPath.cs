using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The way to a place, around what lies between. Over terrain it is flown from point to point, each with its height;
/// the vehicle stops at corners only.
/// </summary>
internal sealed class TransitPath
{
    // A corner counts as flown within this.
    private const double ArrivalMetres = 2;

    private IReadOnlyList<(PlanePoint At, double WithinMetres)> _points = [];
    private int _next;

    /// <summary>Where it ends.</summary>
    public PlanePoint To { get; private set; }

    /// <summary>Metres to go from where it was begun.</summary>
    public double Length { get; private set; }

    /// <summary>Plans the way.</summary>
    public void Begin(MissionFlight flight, PlanePoint to)
    {
        PlanePoint at = flight.Position;
        IReadOnlyList<PlanePoint> corners = flight.Plan!.PathBetween(at, to);
        (To, _next, Length) = (to, 0, 0);
        foreach (PlanePoint corner in corners.Append(to))
        {
            Length += at.DistanceTo(corner);
            at = corner;
        }

        _points = flight.Plan.Terrain is null
            ? corners.Select(c => (c, ArrivalMetres)).ToArray()
            : PointsOf(flight.Position, corners, to, PathFollower.Lookahead(flight.Mission.SpeedMetresPerSecond));
    }

    /// <summary>Where to fly now.</summary>
    public PlanePoint Next(MissionFlight flight)
    {
        while (_next < _points.Count && flight.Position.DistanceTo(_points[_next].At) <= _points[_next].WithinMetres)
            _next++;
        return _next < _points.Count ? _points[_next].At : To;
    }

    // At most half a lookahead apart; passed by when they are nearer than a lookahead.
    private static List<(PlanePoint At, double WithinMetres)> PointsOf(
        PlanePoint at, IReadOnlyList<PlanePoint> corners, PlanePoint to, double lookahead)
    {
        var points = new List<(PlanePoint At, double WithinMetres)>();
        for (int i = 0; i <= corners.Count; i++)
        {
            PlanePoint end = i < corners.Count ? corners[i] : to;
            int pieces = (int)Math.Ceiling(2 * at.DistanceTo(end) / lookahead);
            for (int piece = 1; piece < pieces; piece++)
                points.Add((at + (piece / (double)pieces * (end - at)), lookahead));
            if (i < corners.Count)
                points.Add((end, ArrivalMetres));
            at = end;
        }

        return points;
    }
}
