using System;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The way of a search for a target that was lost: squares around the place where it was last expected, one outside the
/// other (expanding square search; IMO/ICAO: IAMSAR Manual, volume II), as far out as it may have gone by now, and then
/// from the middle again. One thread.
/// </summary>
internal sealed class GrowingSearch
{
    /// <summary>It is not searched for any farther out, metres.</summary>
    public const double MaxRadiusMetres = 100;

    /// <summary>Nor for longer.</summary>
    public static readonly TimeSpan MaxTime = TimeSpan.FromSeconds(60);

    // What it began with is uncertain by that.
    private const double StartRadiusMetres = 15;

    private const double ArrivalMetres = 5;

    // So many corners reach the largest radius at the least distance between two squares.
    private const int MaxCorners = 48;
    private const double MinPitchMetres = 10;

    private readonly PlanePoint _middle;
    private readonly double _heading;
    private readonly double _pitch;
    private readonly double _speed;
    private int _corner;
    private PlanePoint _goal;

    /// <param name="middle">Where the target was last expected.</param>
    /// <param name="headingRadians">Where it went.</param>
    /// <param name="pitchMetres">From one square to the next: what a picture shows.</param>
    /// <param name="metresPerSecond">How fast it may have gone on.</param>
    public GrowingSearch(PlanePoint middle, double headingRadians, double pitchMetres, double metresPerSecond)
    {
        (_middle, _goal, _heading, _speed) = (middle, middle, headingRadians, metresPerSecond);
        _pitch = Math.Max(MinPitchMetres, pitchMetres);
    }

    /// <summary>How far from the middle it may be.</summary>
    /// <param name="lost">For how long it was not seen.</param>
    public double RadiusMetres(TimeSpan lost)
        => Math.Min(MaxRadiusMetres, StartRadiusMetres + (_speed * lost.ExactSeconds));

    /// <summary>What is to be looked at next.</summary>
    /// <param name="seen">The middle of the picture now.</param>
    /// <param name="lost">For how long it was not seen.</param>
    /// <param name="isInside">Whether the vehicle can look at a place.</param>
    public PlanePoint Next(PlanePoint seen, TimeSpan lost, Func<PlanePoint, bool> isInside)
    {
        if (seen.DistanceTo(_goal) > ArrivalMetres)
            return _goal;
        double radius = RadiusMetres(lost);
        for (int tried = 0; tried < MaxCorners; tried++)
        {
            _corner++;
            if (_middle.DistanceTo(Corner(_corner)) > radius * Math.Sqrt(2))
                _corner = 0;
            PlanePoint next = Corner(_corner);
            if (isInside(next))
                return _goal = next;
            if (_corner == 0 && tried > 0)
                break;
        }

        return _goal;
    }

    // The legs are 1, 1, 2, 2, 3, 3 and so on times the pitch long, each to the right of the one before.
    private PlanePoint Corner(int number)
    {
        PlanePoint at = _middle;
        for (int leg = 0; leg < number; leg++)
            at += ((leg / 2) + 1) * _pitch * PlanePoint.Towards(_heading + (leg * Math.PI / 2));
        return at;
    }
}
