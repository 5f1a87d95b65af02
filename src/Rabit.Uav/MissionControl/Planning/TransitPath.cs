using System.Collections.Generic;

namespace Rabit.Uav.MissionControl;

/// <summary>The way to a place, around what lies between.</summary>
internal sealed class TransitPath
{
    // A corner counts as flown within this.
    private const double ArrivalMetres = 2;

    private IReadOnlyList<PlanePoint> _corners = [];
    private int _next;

    /// <summary>Where it ends.</summary>
    public PlanePoint To { get; private set; }

    /// <summary>Metres to go from where it was begun.</summary>
    public double Length { get; private set; }

    /// <summary>Plans the way.</summary>
    public void Begin(MissionFlight flight, PlanePoint to)
    {
        PlanePoint at = flight.Position;
        (_corners, To, _next, Length) = (flight.Plan!.PathBetween(at, to), to, 0, 0);
        foreach (PlanePoint corner in _corners)
        {
            Length += at.DistanceTo(corner);
            at = corner;
        }

        Length += at.DistanceTo(to);
    }

    /// <summary>Where to fly now.</summary>
    public PlanePoint Next(MissionFlight flight)
    {
        while (_next < _corners.Count && flight.Position.DistanceTo(_corners[_next]) <= ArrivalMetres)
            _next++;
        return _next < _corners.Count ? _corners[_next] : To;
    }
}
