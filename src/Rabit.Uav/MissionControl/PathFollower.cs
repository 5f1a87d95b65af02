using System;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Follows a path segment by carrot chasing: flies to its start, then commands a point on it a lookahead distance in
/// front of the vehicle, so that the cross-track error that wind causes is removed. A new point is commanded when the
/// last one comes near, not in every tick.
/// </summary>
internal sealed class PathFollower : ILaneFollower
{
    /// <summary>Acceptance radius: within it a point is reached.</summary>
    public const double ArrivalMetres = 2;

    // It drifts while it brakes.
    private const double CornerMetres = 0.5;

    // Slower than this the vehicle has stopped.
    private const double StoppedMetresPerSecond = 1.5;

    // The lookahead is at least this, in flying time and in metres, and longer than the braking distance.
    private const double LookaheadSeconds = 3;
    private const double MinLookaheadMetres = 15;
    private const double BrakingMetresPerSecondSquared = 1.5;

    // Three times the nominal duration, and time to turn and to accelerate.
    private const double TimeFactor = 3;
    private const double TimeReserveSeconds = 60;

    private readonly TransitPath _transit = new();
    private LaneSegment _segment;
    private double _height;
    private double _speed;
    private double _targetMetres;
    private TimeSpan _until;
    private bool _isOnSegment;

    /// <summary>How much of the segment has been flown.</summary>
    public double FlownMetres { get; private set; }

    /// <summary>Begins a segment.</summary>
    public void Begin(MissionFlight flight, LaneSegment segment, double heightMetres)
    {
        _segment = segment;
        _height = heightMetres;
        _speed = flight.Mission.SpeedMetresPerSecond;
        (_targetMetres, FlownMetres) = (0, 0);

        // From a leg to the one that begins where it ended it does not stop.
        _isOnSegment = flight.Position.DistanceTo(segment.Start) <= ArrivalMetres + CornerMetres
            && flight.IsAtHeight(segment.Start, heightMetres, ArrivalMetres);
        _transit.Begin(flight, segment.Start);
        _until = flight.ActiveTime + TimeLimit(flight, _transit.Length + segment.Length);
    }

    /// <summary>Time-out for a path of some length.</summary>
    public static TimeSpan TimeLimit(MissionFlight flight, double metres)
        => TimeSpan.OfSeconds(TimeReserveSeconds + (TimeFactor * metres / flight.Mission.SpeedMetresPerSecond));

    /// <summary>
    /// More time for the way that a leg may still have, where the operator has made the vehicle slower.
    /// </summary>
    /// <param name="flight">The state of the mission.</param>
    /// <param name="speed">The speed of the time-out so far; now that of the mission.</param>
    public static TimeSpan MoreTime(MissionFlight flight, ref double speed)
    {
        double before = speed;
        speed = flight.Mission.SpeedMetresPerSecond;
        return speed < before
            ? TimeSpan.OfSeconds(TimeFactor * FlightPlan.MaxAreaDistanceMetres * ((1 / speed) - (1 / before)))
            : TimeSpan.Zero;
    }

    /// <summary>Whether the vehicle is at a point and has stopped.</summary>
    public static bool HasArrived(MissionFlight flight, PlanePoint at, double heightMetres)
        => flight.Position.DistanceTo(at) <= ArrivalMetres && flight.GroundSpeed <= StoppedMetresPerSecond
            && flight.IsAtHeight(at, heightMetres, ArrivalMetres);

    /// <summary>Updates the goal.</summary>
    /// <param name="flight">The state of the mission.</param>
    /// <param name="isLate">Whether the time-out has passed.</param>
    /// <returns>Whether the segment is flown.</returns>
    public bool Tick(MissionFlight flight, out bool isLate)
    {
        _until += MoreTime(flight, ref _speed);
        isLate = flight.ActiveTime > _until;
        if (!_isOnSegment)
        {
            flight.SetGoalPosition(_transit.Next(flight), _height, _segment.HeadingRadians);
            _isOnSegment = HasArrived(flight, _segment.Start, _height);
            if (!_isOnSegment)
                return false;
        }

        PlanePoint along = (1 / _segment.Length) * (_segment.End - _segment.Start);
        double flown = (flight.Position - _segment.Start).Dot(along);
        FlownMetres = Math.Max(FlownMetres, flown);
        if (flown >= _segment.Length - ArrivalMetres)
            return true;
        double lookahead = Lookahead(_speed);
        while (_targetMetres < _segment.Length && _targetMetres < flown + lookahead)
            _targetMetres = Math.Min(_segment.Length, _targetMetres + (lookahead / 2));
        flight.SetGoalPosition(_segment.Start + (_targetMetres * along), _height, _segment.HeadingRadians);
        return false;
    }

    /// <summary>How far away, at most, the point is that is commanded on a segment.</summary>
    public static double MaxGoalMetres(double speed) => 1.5 * Lookahead(speed);

    /// <summary>How far the point that is commanded is in front of the vehicle.</summary>
    public static double Lookahead(double speed)
    {
        double brakingMetres = speed * speed / (2 * BrakingMetresPerSecondSquared);
        return Math.Max(Math.Max(MinLookaheadMetres, LookaheadSeconds * speed), brakingMetres);
    }
}
